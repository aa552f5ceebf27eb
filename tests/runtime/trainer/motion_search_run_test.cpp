// Runs of the agent `motion_search` that comes with the humanoid.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "runtime/trainer/results/motion_agent.h"
#include "runtime/training/learning/motion_search.h"
#include "tests/runtime/trainer/learner_run.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

class MotionSearchRunTest : public LearnerRunTest {
 protected:
  MotionSearchRunTest()
      : LearnerRunTest({.task = PluginFile("leaning"),
                        .profile = "fast",
                        .agent = "motion_search",
                        .robot = "humanoid",
                        .settings = {"learner.population=4", "action_space.harmonics=1"}}) {}
};

double CurveIn(const EpisodeRecord& episode, const std::string& name) {
  for (const NamedValue& each : episode.learner) {
    if (each.name == name) return each.value;
  }
  ADD_FAILURE() << name;
  return 0;
}

TEST_F(MotionSearchRunTest, TriesAnotherMotionInEachEpisode) {
  ASSERT_EQ(Train("run", 9), 0);
  const std::vector<EpisodeRecord> episodes = EpisodesOf("run");
  ASSERT_THAT(episodes, SizeIs(9));
  double best = -1e9;
  std::set<double> returns;
  for (const EpisodeRecord& episode : episodes) {
    best = std::max(best, episode.active.episode_return);
    returns.insert(episode.active.episode_return);
    EXPECT_EQ(CurveIn(episode, "best"), best);
    EXPECT_EQ(CurveIn(episode, "population"), 4);
    EXPECT_EQ(episode.actions, (episode.steps + 29) / 30);
  }
  EXPECT_THAT(returns, SizeIs(9));
  EXPECT_EQ(CurveIn(episodes.back(), "generation"), 2);
}

TEST_F(MotionSearchRunTest, GoesOnBitForBitInTheMiddleOfAGeneration) {
  ASSERT_EQ(Train("whole", 10), 0);
  ASSERT_EQ(Train("parts", 2), 0);
  ASSERT_EQ(Resume("parts", 7), 0);
  ASSERT_EQ(Resume("parts", 10), 0);
  EXPECT_TRUE(TraceOf("parts") == TraceOf("whole"));
}

TEST_F(MotionSearchRunTest, WithoutLearningTheBestMotionEarnsWhatItDid) {
  ASSERT_EQ(Train("run", 10), 0);
  const std::vector<double> returns = ReturnsOf("run");
  const PolicyEvaluation evaluation = Evaluate("run", 2);
  EXPECT_THAT(evaluation.returns, SizeIs(2));
  // The task pays for how many episodes there have been.
  const size_t best = static_cast<size_t>(std::ranges::max_element(returns) - returns.begin());
  EXPECT_NEAR(evaluation.returns[0], returns[best], 0.125 * 10);
}

TEST_F(MotionSearchRunTest, SearchesAnotherTaskAroundTheBestMotion) {
  ASSERT_EQ(Train("run", 6), 0);
  {
    const ServedRun run(Run("run"), [&] { return Resume("run", 7, LiveRun::WhenDone::kWait); });
    run.Request("swap", {{"name", "task"}, {"file", PluginFile("upright")}});
    run.Request("resume", {{"episodes", 12}});
    run.WaitUntilDone();
  }
  const std::vector<EpisodeRecord> episodes = EpisodesOf("run");
  ASSERT_THAT(episodes, SizeIs(12));
  EXPECT_EQ(CurveIn(episodes[6], "generation"), 1);
  EXPECT_EQ(CurveIn(episodes[7], "generation"), 0);
  EXPECT_EQ(CurveIn(episodes[7], "best"), episodes[7].active.episode_return);
  EXPECT_EQ(CurveIn(episodes[11], "generation"), 1);  // of 4 candidates since the swap
  ASSERT_EQ(Resume("run", 13), 0);
  EXPECT_THAT(MotionAgent(Run("run")), HasSubstr(" in upright ("));
}

TEST_F(MotionSearchRunTest, APolicyStandsOnTheBestMotion) {
  ASSERT_EQ(Train("run", 10), 0);
  const std::string text = MotionAgent(Run("run"));
  const std::filesystem::path file = Run("run").parent_path() / "on_motion.toml";
  std::ofstream(file) << text;
  // Without offsets it does what the search has found.
  task().agent = file.string();
  task().settings = {"action_space.scale=0", "action_space.hold=30", "learner.hidden=[4]"};
  ASSERT_EQ(Train("on_motion", 2), 0);
  const std::vector<double> found = ReturnsOf("run");
  const size_t best = static_cast<size_t>(std::ranges::max_element(found) - found.begin());
  // The task also pays eighths for how many episodes there have been.
  EXPECT_NEAR(std::remainder(ReturnsOf("on_motion")[0] - found[best], 0.125), 0, 1e-12);
  EXPECT_THAT(ReturnsOf("on_motion"), SizeIs(2));
  EXPECT_EQ(Resume("on_motion", 3), 0);  // without that file
}

TEST_F(MotionSearchRunTest, OnlyASearchHasAMotionToStandOn) {
  task().agent = "ppo";
  task().settings = {"learner.hidden=[4]"};
  ASSERT_EQ(Train("run", 1), 0);
  try {
    MotionAgent(Run("run"));
    FAIL();
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), HasSubstr("train one with `--agent motion_search`"));
  }
}

}  // namespace
}  // namespace runtime
