// That a learner is whatever module implements runtime/training/learning/learner.h: one of which
// neither the program nor its agents know is trained by what the program's commands call.
#include "tests/runtime/trainer/learner_run.h"
#include "tests/runtime/trainer/random_targets.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::Ne;
using testing::SizeIs;

class LearnerTest : public LearnerRunTest {
 protected:
  LearnerTest()
      : LearnerRunTest({.task = PluginFile("leaning"),
                        .profile = "fast",
                        .agent = AGENTS "/random_targets.agent.toml",
                        .robot = "humanoid",
                        .settings = {"policy.pace=0.005"}}) {
    types().Add<RandomTargets>("RandomTargets");
  }
};

double ReachIn(const EpisodeRecord& episode) { return episode.learner.at(0).value; }

TEST_F(LearnerTest, IsTrainedAndShowsItself) {
  ASSERT_EQ(Train("run", 5), 0);
  const RunDatabase database = RunDatabase::OpenToRead(Run("run"));
  EXPECT_EQ(database.ReadRun().profile, "fast");
  const std::vector<CurveRecord> curves = database.ReadLearnerCurves();
  ASSERT_THAT(curves, SizeIs(1));
  EXPECT_EQ(curves[0].name, "reach");
  EXPECT_EQ(curves[0].unit, "rad");
  const std::vector<EpisodeRecord> episodes = EpisodesOf("run");
  ASSERT_THAT(episodes, SizeIs(5));
  for (const EpisodeRecord& episode : episodes) {
    EXPECT_GT(episode.actions, 2);
    EXPECT_EQ(episode.actions, (episode.steps + 7) / 8);  // of 8 time steps, but for the last
    ASSERT_THAT(episode.learner, SizeIs(1));
    EXPECT_EQ(episode.learner[0].name, "reach");
  }
  EXPECT_NE(ReachIn(episodes[0]), RandomTargets::kFirstReach);
  EXPECT_NE(ReachIn(episodes[1]), ReachIn(episodes[0]));
  EXPECT_NE(ReturnsOf("run")[1], ReturnsOf("run")[0]);
}

TEST_F(LearnerTest, GoesOnBitForBit) {
  ASSERT_EQ(Train("whole", 6), 0);
  ASSERT_EQ(Train("parts", 2), 0);
  ASSERT_EQ(Resume("parts", 3), 0);
  ASSERT_EQ(Resume("parts", 6), 0);
  EXPECT_TRUE(TraceOf("parts") == TraceOf("whole"));
}

TEST_F(LearnerTest, KeepsWhatItLearnedWhenTheTaskIsSwappedUnlessItIsToldToForget) {
  ASSERT_EQ(Train("run", 2), 0);
  {
    const ServedRun run(Run("run"), [&] { return Resume("run", 3, LiveRun::WhenDone::kWait); });
    const json swap = {{"name", "task"}, {"file", PluginFile("upright")}};
    EXPECT_EQ(run.Request("swap", swap)["task"], "upright");
    run.Request("resume", {{"episodes", 4}});
    run.WaitUntilDone();
    json forget = {{"name", "task"}, {"file", PluginFile("leaning")}, {"forget", true}};
    run.Request("swap", forget);
    run.Request("set", {{"name", "policy.pace"}, {"value", 0}});
    run.Request("resume", {{"episodes", 5}});
    run.WaitUntilDone();
  }
  const std::vector<EpisodeRecord> episodes = EpisodesOf("run");
  ASSERT_THAT(episodes, SizeIs(5));
  EXPECT_EQ(episodes[2].active.task, 1);
  EXPECT_EQ(episodes[3].active.task, 2);
  EXPECT_NE(ReachIn(episodes[2]), RandomTargets::kFirstReach);
  EXPECT_NE(ReachIn(episodes[3]), RandomTargets::kFirstReach);
  EXPECT_EQ(ReachIn(episodes[4]), RandomTargets::kFirstReach);
  // All of that is part of the run.
  ASSERT_EQ(Resume("run", 6), 0);
  EXPECT_EQ(ReachIn(EpisodesOf("run").back()), RandomTargets::kFirstReach);
}

TEST_F(LearnerTest, IsEvaluatedWithoutLearning) {
  ASSERT_EQ(Train("run", 4), 0);
  const PolicyEvaluation evaluation = Evaluate("run", 4);
  EXPECT_EQ(Evaluate("run", 4).returns, evaluation.returns);
  EXPECT_EQ(evaluation.checkpoint_episode, 4);
  ASSERT_EQ(Resume("run", 8), 0);
  const std::vector<double> returns = ReturnsOf("run");
  const std::vector<double> learned(returns.begin() + 4, returns.end());
  EXPECT_THAT(evaluation.returns, Ne(learned));  // the run learns on
}

}  // namespace
}  // namespace runtime
