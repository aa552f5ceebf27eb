#include "runtime/analysis/study/experiments.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/runtime/analysis/report/sample_run.h"
#include "tests/runtime/analysis/study/sample_study.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class ReadStudyRunsTest : public testing::Test {
 protected:
  // A run in this folder of the study, which has learned nothing yet.
  void Write(const std::string& name, const RunRecord& run) {
    runs_.push_back(folder() / name);
    RunDatabase::Create(runs_.back(), run);
  }
  Study Read() { return ReadStudyRuns(folder(), runs_); }
  const std::filesystem::path& folder() const { return folder_.path(); }

  TemporaryFolder folder_;
  std::vector<std::filesystem::path> runs_;
};

TEST_F(ReadStudyRunsTest, AnExperimentIsAFolderOfSeeds) {
  RunRecord second = SampleRunRecord();
  second.seed = 2;
  Write("crawling/seed1", SampleRunRecord());
  Write("crawling/seed2", second);
  Write("again/seed1", SampleRunRecord());
  const Study study = Read();
  ASSERT_THAT(study.experiments, SizeIs(2));
  EXPECT_EQ(study.experiments[0].name, "crawling");
  ASSERT_THAT(study.experiments[0].runs, SizeIs(2));
  EXPECT_EQ(study.experiments[0].runs[1].name, "crawling/seed2");
  EXPECT_EQ(study.experiments[0].runs[1].record.seed, 2u);
  EXPECT_EQ(study.experiments[1].name, "again");
}

TEST_F(ReadStudyRunsTest, RunsThatDifferInMoreThanTheSeedAreApart) {
  RunRecord fast = SampleRunRecord();
  fast.profile = "fast";
  RunRecord careful = SampleRunRecord();
  careful.tasks[0].task_hash = "c0ffee";
  RunRecord warm = SampleRunRecord();
  warm.agent += "# warmer\n";
  Write("a", SampleRunRecord());
  Write("b", fast);
  Write("c", careful);
  Write("d", warm);
  std::vector<std::string> names;
  for (const StudyExperiment& experiment : Read().experiments) names.push_back(experiment.name);
  EXPECT_THAT(names, ElementsAre("crawling-paper", "crawling-fast", "crawling-paper (2)",
                                 "crawling-paper (3)"));
}

TEST_F(ReadStudyRunsTest, ARunThatCannotBeReadIsLeftOut) {
  Write("good", SampleRunRecord());
  runs_.push_back(folder() / "bad");
  std::filesystem::create_directories(runs_.back());
  std::ofstream(runs_.back() / "run.db") << std::string(5000, 'x');
  const Study study = Read();
  ASSERT_THAT(study.experiments, SizeIs(1));
  EXPECT_THAT(study.notes, ElementsAre(HasSubstr("bad is left out: ")));
}

TEST_F(ReadStudyRunsTest, ARunThatWasChangedIsNoted) {
  Write("a", SampleRunRecord());
  Write("b", SampleRunRecord());
  RunDatabase database = RunDatabase::Open(folder() / "b");
  database.AddChange({0, 1, 0, "", SetParameter{"task.weight", int64_t{2}}, "set task.weight = 2"});
  database.AddChange({0, 2, 0, "", SetParameter{"task.weight", int64_t{3}}, "set task.weight = 3"});
  const Study study = Read();
  EXPECT_EQ(study.experiments[0].runs[1].changes, 2u);
  EXPECT_THAT(study.notes, ElementsAre("b was changed while it learned, 2 times; its own report "
                                       "says how."));
}

TEST_F(ReadStudyRunsTest, ARunIsFinishedWhenAllItsEpisodesAreDone) {
  WriteStudyRun(folder() / "a", {.seed = 1, .episodes = 5, .planned = 5});
  WriteStudyRun(folder() / "b", {.seed = 2, .episodes = 4, .planned = 5});
  runs_ = {folder() / "a", folder() / "b"};
  const Study study = Read();
  EXPECT_THAT(study.notes, IsEmpty());
  EXPECT_TRUE(study.experiments[0].runs[0].is_finished());
  EXPECT_FALSE(study.experiments[0].runs[1].is_finished());
}

}  // namespace
}  // namespace runtime
