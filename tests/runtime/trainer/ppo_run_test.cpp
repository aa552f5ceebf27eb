// Runs of the agent `ppo` that comes with the humanoid.
#include <algorithm>
#include <cmath>

#include "tests/runtime/trainer/learner_run.h"

namespace runtime {
namespace {

class PpoRunTest : public LearnerRunTest {
 protected:
  // An update in every second or third of the task's short episodes.
  PpoRunTest()
      : LearnerRunTest(
            {.task = PluginFile("leaning"),
             .profile = "fast",
             .agent = "ppo",
             .robot = "humanoid",
             .settings = {"learner.hidden=[8, 8]", "learner.batch=20", "learner.minibatch=8",
                          "learner.deviation=0.5", "learner.deviation_decisions=1000"}}) {}

  static double Shown(const EpisodeRecord& episode, const std::string& curve) {
    const auto found = std::ranges::find(episode.learner, curve, &NamedValue::name);
    return found == episode.learner.end() ? -1 : found->value;
  }
};

TEST_F(PpoRunTest, IsTrainedAndShowsItself) {
  ASSERT_EQ(Train("run", 8), 0);
  const std::vector<EpisodeRecord> episodes = EpisodesOf("run");
  ASSERT_EQ(episodes.size(), 8u);
  EXPECT_TRUE(std::isnan(Shown(episodes.front(), "divergence")));  // nothing was learned yet
  for (const char* curve : {"entropy", "deviation", "divergence", "learning_rate", "policy_loss",
                            "value_loss", "explained_variance"}) {
    EXPECT_TRUE(std::isfinite(Shown(episodes.back(), curve))) << curve;
  }
  EXPECT_LT(Shown(episodes.back(), "deviation"), 0.5);
  for (const EpisodeRecord& episode : episodes) {
    EXPECT_EQ(episode.actions, (episode.steps + 7) / 8);
  }
}

TEST_F(PpoRunTest, GoesOnBitForBit) {
  ASSERT_EQ(Train("whole", 9), 0);
  ASSERT_EQ(Train("parts", 2), 0);
  ASSERT_EQ(Resume("parts", 3), 0);
  ASSERT_EQ(Resume("parts", 4), 0);
  ASSERT_EQ(Resume("parts", 9), 0);
  EXPECT_TRUE(TraceOf("parts") == TraceOf("whole"));
}

TEST_F(PpoRunTest, KeepsWhatItLearnedWhenTheTaskIsSwappedUnlessItIsToldToForget) {
  ASSERT_EQ(Train("run", 8), 0);
  {
    const ServedRun run(Run("run"), [&] { return Resume("run", 9, LiveRun::WhenDone::kWait); });
    run.Request("swap", {{"name", "task"}, {"file", PluginFile("upright")}});
    run.Request("set", {{"name", "learner.epochs"}, {"value", 2}});
    run.Request("resume", {{"episodes", 10}});
    run.WaitUntilDone();
    run.Request("swap", {{"name", "task"}, {"file", PluginFile("leaning")}, {"forget", true}});
    run.Request("resume", {{"episodes", 11}});
    run.WaitUntilDone();
  }
  const std::vector<EpisodeRecord> episodes = EpisodesOf("run");
  ASSERT_EQ(episodes.size(), 11u);
  EXPECT_LT(Shown(episodes[9], "deviation"), 0.5);
  EXPECT_TRUE(std::isnan(Shown(episodes[10], "deviation")) ||
              Shown(episodes[10], "deviation") > Shown(episodes[9], "deviation"));
  ASSERT_EQ(Resume("run", 12), 0);
}

TEST_F(PpoRunTest, IsEvaluatedByItsMeanActions) {
  ASSERT_EQ(Train("run", 6), 0);
  const std::vector<double> returns = Evaluate("run", 3).returns;
  // All else being equal, the task pays 0.125 more for each of the eight actions of an episode.
  EXPECT_NEAR(returns[1] - returns[0], 1, 1e-9);
  EXPECT_NEAR(returns[2] - returns[1], 1, 1e-9);
  EXPECT_EQ(Evaluate("run", 3).returns, returns);
  const std::vector<double> learned = ReturnsOf("run");
  EXPECT_GT(std::abs(learned[5] - learned[4] - 1), 1e-6);
}

}  // namespace
}  // namespace runtime
