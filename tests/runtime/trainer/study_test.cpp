#include <fstream>

#include "runtime/training/run/run_database.h"
#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using testing::HasSubstr;

class StudyTest : public TrainerTest {
 protected:
  std::string Write(const std::string& text) const {
    std::ofstream(folder() / "study.toml") << text;
    return (folder() / "study.toml").string();
  }
  // Two experiments with the task `leaning`.
  std::string TwoExperiments(const std::string& seeds, int episodes) const {
    return Write("profile = 'fast'\nseeds = " + seeds + "\nepisodes = " + std::to_string(episodes) +
                 "\n[[experiments]]\ntask = '" + TaskFile("leaning") +
                 "'\n[[experiments]]\nname = 'cool'\ntask = '" + TaskFile("leaning") +
                 "'\nsettings = ['learner.temperature=1']\n");
  }
  ProgramResult Study(const std::string& file) const {
    return Trainer({"study", file, "--out", RunFolder("study"), "--jobs", "2"});
  }
  size_t EpisodesOf(const std::string& run) const {
    return RunDatabase::OpenToRead(RunFolder(run)).ReadEpisodes().size();
  }
};

TEST_F(StudyTest, TrainsEachExperimentWithEachSeed) {
  const ProgramResult result = Study(TwoExperiments("[1, 5]", 1));
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("\ncool/seed1          finished"));
  EXPECT_THAT(result.output, HasSubstr("\nleaning-fast/seed5  finished"));
  EXPECT_THAT(result.output, HasSubstr("4 finished   4/4 episodes"));
  const RunRecord run = RunDatabase::OpenToRead(RunFolder("study/cool/seed5")).ReadRun();
  EXPECT_THAT(run.agent, HasSubstr("temperature = 1.0"));
  EXPECT_EQ(run.seed, 5u);
}

TEST_F(StudyTest, TrainsInTheOrderOfTheFile) {
  const std::string file = TwoExperiments("[7]", 1);
  const ProgramResult result = Trainer({"study", file, "--out", RunFolder("study"), "--jobs", "1"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_LT(result.output.find("leaning-fast/seed7"), result.output.find("cool/seed7"));
}

TEST_F(StudyTest, CalledAgainAddsWhatIsNewAndRepeatsNothing) {
  ASSERT_EQ(Study(TwoExperiments("'1..2'", 1)).exit_status, 0);
  const Trace before = TraceOf("study/cool/seed1");
  const ProgramResult result = Study(TwoExperiments("'1..3'", 2));
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("6 finished   12/12 episodes"));
  EXPECT_EQ(TraceOf("study/cool/seed1").episodes.front(), before.episodes.front());
  EXPECT_EQ(EpisodesOf("study/leaning-fast/seed3"), 2u);
}

TEST_F(StudyTest, RunsOfAnotherAgentAreNotMixedIn) {
  ASSERT_EQ(Study(TwoExperiments("[1]", 1)).exit_status, 0);
  const std::string file =
      Write("seeds = [1, 2]\nepisodes = 1\n[[experiments]]\nname = 'cool'\n" +
            std::string("profile = 'fast'\ntask = '") + TaskFile("leaning") + "'\n");
  const ProgramResult result = Study(file);
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("study.toml:3:1: "));
  EXPECT_THAT(result.errors, HasSubstr("`learner.temperature` is 1.0 there and 5.0 here; give "
                                       "this experiment another `name`"));
  EXPECT_FALSE(std::filesystem::exists(RunFolder("study/cool/seed2")));
}

TEST_F(StudyTest, MistakesAreReportedWithTheirPlace) {
  const std::pair<std::string, std::string> mistakes[] = {
      {"episodes = 0\n[[experiments]]\n", "study.toml:1:12: expected an integer, at least 1"},
      {"seeds = '3..1'\n[[experiments]]\n", "study.toml:1:9: this is not a range of seeds"},
      {"[[experiments]]\nseeds = [1]\n", "study.toml:1:1: an experiment needs a `task`"},
      {"[[experiments]]\ntask = 'x.task'\n", "an experiment needs `seeds`"},
      {"[[experiments]]\ntask = 'x.task'\nsed = [1]\n",
       "study.toml:3:1: an experiment has no `sed`"},
      {"seeds = [1]\n", "a study needs [[experiments]]"},
      {"seeds = [\n", "study.toml:"},
      {"[[experiments]]\nname = '../x'\n", "study.toml:2:8: this cannot name a folder"},
  };
  for (const auto& [text, message] : mistakes) {
    const ProgramResult result = Study(Write(text));
    EXPECT_EQ(result.exit_status, 1) << text;
    EXPECT_THAT(result.errors, HasSubstr(message)) << text;
  }
  EXPECT_EQ(Study((folder() / "nowhere.toml").string()).exit_status, 1);
}

}  // namespace
}  // namespace runtime
