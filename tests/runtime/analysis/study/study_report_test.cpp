#include "runtime/analysis/study/study_report.h"

#include <gmock/gmock.h>

#include <fstream>

#include "runtime/training/run/run_files.h"
#include "tests/runtime/analysis/report/report_page.h"
#include "tests/runtime/analysis/study/sample_study.h"
#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

class StudyReportTest : public testing::Test {
 protected:
  void SetUp() override { runs_ = WriteStudy(folder()); }
  json Data() { return DataOfPage(WriteStudyReport(folder(), runs_, {})); }
  const std::filesystem::path& folder() const { return folder_.path(); }

  TemporaryFolder folder_;
  std::vector<std::filesystem::path> runs_;
};

TEST_F(StudyReportTest, FiguresNameWhatCameOutOfEachExperiment) {
  const json figures = StudyFigures(folder(), runs_);
  ASSERT_THAT(figures["experiments"], SizeIs(2));
  const json& crawling = figures["experiments"][0];
  EXPECT_EQ(crawling["name"], "crawling");
  EXPECT_EQ(crawling["task"], "crawling");
  EXPECT_EQ(crawling["profile"], "paper");
  EXPECT_EQ(crawling["settings"][0]["name"], "task.fall_penalty");
  EXPECT_THAT(crawling["command"].get<std::string>(), EndsWith(" --seed 1 --runs 8"));
  EXPECT_EQ(crawling["final_return"]["count"], 7);  // those that are finished
  EXPECT_EQ(crawling["is_settled"], true);
  EXPECT_EQ(crawling["cpu_minutes"]["greatest"], 1);  // 40 episodes of 1.5 s
  ASSERT_THAT(crawling["runs"], SizeIs(8));
  EXPECT_EQ(crawling["runs"][5]["group"], 1);
  EXPECT_EQ(crawling["runs"][7]["group"], json());
  EXPECT_EQ(crawling["runs"][7]["state"], "interrupted");
  EXPECT_THAT(crawling["curve"]["mean"], SizeIs(40));
}

TEST_F(StudyReportTest, FiguresTellWhatRemainsInOtherProfiles) {
  const json crawling = StudyFigures(folder(), runs_)["experiments"][0];
  ASSERT_THAT(crawling["evaluations"], SizeIs(2));
  const json& fast = crawling["evaluations"][0];
  EXPECT_EQ(fast["profile"], "fast");
  EXPECT_EQ(fast["return"]["count"], 7);
  EXPECT_DOUBLE_EQ(fast["share"], 0.9);
  EXPECT_DOUBLE_EQ(fast["median_share"], 0.9);
  EXPECT_TRUE(fast["return"]["low"].is_number());
  const json& run = crawling["runs"][1]["evaluations"][1];
  EXPECT_EQ(run["profile"], "paper-tree");
  EXPECT_EQ(run["checkpoint_episode"], 40);
  EXPECT_DOUBLE_EQ(run["learned_return"], 104);
  EXPECT_DOUBLE_EQ(run["share"], 1.01);
  EXPECT_THAT(crawling["runs"][7]["evaluations"], SizeIs(0));
}

// The first term is paid eleven parts of twelve, the second takes one.
TEST_F(StudyReportTest, SharesOfTermsCountWhatIsTaken) {
  const json terms = StudyFigures(folder(), runs_)["experiments"][0]["terms"];
  EXPECT_EQ(terms[0]["name"], "forward");
  EXPECT_NEAR(terms[0]["share"].get<double>(), 11. / 12, 0.02);
  EXPECT_NEAR(terms[1]["share"].get<double>(), -1. / 12, 0.02);
  EXPECT_EQ(terms[2]["share"], 0);
}

TEST_F(StudyReportTest, ASentenceBelongsToTheGroupOfItsRun) {
  const json groups = StudyFigures(folder(), runs_)["experiments"][0]["groups"];
  ASSERT_THAT(groups, SizeIs(2));
  EXPECT_THAT(groups[0]["sentences"], SizeIs(0));
  EXPECT_EQ(groups[1]["sentences"], (json{"Crawls fast."}));
  EXPECT_DOUBLE_EQ(groups[0]["share"].get<double>(), 5. / 7);
  EXPECT_EQ(groups[1]["runs"], (json{5, 6}));
}

TEST_F(StudyReportTest, ThePageCarriesTheReplayOfEachGroup) {
  const json groups = Data()["experiments"][0]["groups"];
  for (const json& group : groups) {
    const json& recording = group["recording"];
    EXPECT_EQ(recording["episode"], 40);
    EXPECT_EQ(Floats(recording["poses"]).size(), recording["frames"].get<size_t>() * 18 * 7);
  }
}

TEST_F(StudyReportTest, ThePageCarriesThePicturesOfEachGroup) {
  const json groups = Data()["experiments"][0]["groups"];
  for (const json& group : groups) {
    EXPECT_THAT(group["strip"]["times"], SizeIs(8));
    EXPECT_THAT(group["strip"]["png"].get<std::string>(), StartsWith("iVBORw0KGgo"));
  }
}

TEST_F(StudyReportTest, ThePageHoldsTheCurvesOfAllRuns) {
  const json data = Data();
  const json& crawling = data["experiments"][0];
  EXPECT_THAT(Floats(crawling["runs"][0]["curve"]), SizeIs(40));
  EXPECT_THAT(Floats(crawling["runs"][7]["curve"]), SizeIs(25));
  EXPECT_THAT(Floats(crawling["curve"]["low"]), SizeIs(40));
  EXPECT_THAT(crawling["termCurves"], SizeIs(3));
  EXPECT_THAT(Floats(crawling["metricCurves"][0]["high"]), SizeIs(40));
  EXPECT_THAT(crawling["source"].get<std::string>(), HasSubstr("task crawling for humanoid"));
  EXPECT_THAT(crawling["body"], SizeIs(18));
  EXPECT_EQ(data["title"], folder().filename().string() + " – study");
}

TEST_F(StudyReportTest, ThePageStaysBelowItsSize) {
  for (uint64_t seed = 1; seed <= 60; ++seed) {  // each a group of its own, and 20 s long
    runs_.push_back(folder() / "long" / std::to_string(seed));
    WriteStudyRun(runs_.back(), {.seed = 80, .speed = static_cast<double>(seed)});
  }
  const std::filesystem::path page = WriteStudyReport(folder(), runs_, {});
  EXPECT_LT(std::filesystem::file_size(page), 12u << 20);
  const json data = DataOfPage(page);
  EXPECT_THAT(data["notes"], ElementsAre(HasSubstr("groups have no replay and no pictures here")));
  EXPECT_TRUE(data["experiments"][0]["groups"][0].contains("recording"));  // of five runs
}

// taskc does not lie beside the test, and the sample's task is not what its hash says.
TEST_F(StudyReportTest, PreferencesThatCannotBeFittedLeaveANote) {
  std::ofstream(folder() / "preferences.toml")
      << "[[preference]]\nbetter = 'crawling/seed1'\nworse = 'crawling/seed6'\n";
  const json figures = StudyFigures(folder(), runs_);
  EXPECT_FALSE(figures["experiments"][0].contains("preferences"));
  EXPECT_THAT(figures["notes"].back(), HasSubstr("The preferences are left out: "));
  std::ofstream(folder() / "preferences.toml") << "x = 1\n";
  EXPECT_THAT(ErrorOf([&] { StudyFigures(folder(), runs_); }), HasSubstr("preferences.toml:1:5"));
}

TEST_F(StudyReportTest, WhileNoRunIsFinishedAllCount) {
  std::vector<std::filesystem::path> runs;
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    runs.push_back(folder() / "new" / std::to_string(seed));
    WriteStudyRun(runs.back(), {.seed = seed, .episodes = static_cast<int64_t>(9 * seed - 9)});
  }
  const json figures = StudyFigures(folder(), runs)["experiments"][0];
  EXPECT_EQ(figures["is_settled"], false);
  EXPECT_EQ(figures["final_return"]["count"], 2);  // one has no episode yet
  EXPECT_THAT(figures["groups"], SizeIs(0));
}

TEST_F(StudyReportTest, AStudyWithoutAnEpisodeSaysToWait) {
  WriteStudyRun(folder() / "new", {.episodes = 0});
  EXPECT_THAT(ErrorOf([&] { WriteStudyReport(folder(), {folder() / "new"}, {}); }),
              HasSubstr("no run has a finished episode yet; wait"));
}

}  // namespace
}  // namespace runtime
