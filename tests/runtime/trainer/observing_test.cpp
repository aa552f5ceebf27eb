// That what a task observes reaches a learner, in a run, when that is resumed, when its task is
// swapped and when it is evaluated.
#include <gmock/gmock.h>

#include "tests/runtime/trainer/learner_run.h"
#include "tests/runtime/trainer/linear_policy.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::DoubleNear;
using testing::HasSubstr;
using testing::Ne;
using testing::Pointwise;

class ObservingTest : public LearnerRunTest {
 protected:
  ObservingTest()
      : LearnerRunTest({.task = PluginFile("seeing"),
                        .profile = "fast",
                        .agent = AGENTS "/linear_policy.agent.toml",
                        .robot = "humanoid",
                        .settings = {}}) {
    types().Add<LinearPolicy>("LinearPolicy");
  }

  // The length of what was seen last in each episode.
  std::vector<double> SeenIn(const std::string& name) const {
    std::vector<double> seen;
    for (const EpisodeRecord& episode : EpisodesOf(name)) {
      seen.push_back(episode.learner.at(0).value);
    }
    return seen;
  }
};

TEST_F(ObservingTest, ALearnerSeesWhatTheTaskObserves) {
  ASSERT_EQ(Train("run", 4), 0);
  const std::vector<double> returns = ReturnsOf("run");
  EXPECT_NE(returns[0], returns[1]);
  for (const double seen : SeenIn("run")) EXPECT_GT(seen, 0.9);  // base.up alone is of length 1
}

TEST_F(ObservingTest, GoesOnBitForBit) {
  ASSERT_EQ(Train("whole", 5), 0);
  ASSERT_EQ(Train("parts", 2), 0);
  ASSERT_EQ(Resume("parts", 5), 0);
  EXPECT_TRUE(TraceOf("parts") == TraceOf("whole"));
}

TEST_F(ObservingTest, IsEvaluatedWithoutLearning) {
  ASSERT_EQ(Train("run", 4), 0);
  const PolicyEvaluation evaluation = Evaluate("run", 3);
  EXPECT_EQ(Evaluate("run", 3).returns, evaluation.returns);
  ASSERT_EQ(Resume("run", 7), 0);
  const std::vector<double> returns = ReturnsOf("run");
  EXPECT_THAT(evaluation.returns, Ne(std::vector<double>(returns.begin() + 4, returns.end())));
}

TEST_F(ObservingTest, OnlyATaskThatObservesTheSameTakesTheOthersPlace) {
  ASSERT_EQ(Train("run", 2), 0);
  const ServedRun run(Run("run"), [&] { return Resume("run", 3, LiveRun::WhenDone::kWait); });
  const auto swap = [&](const char* task) {
    return json{{"name", "task"}, {"file", PluginFile(task)}};
  };
  EXPECT_EQ(run.Refusal("swap", swap("seeing_more")),
            "the learner cannot go on with the task `seeing_more`: it would see `base.velocity.x` "
            "(real [m/s]) instead of nothing; train it in a run of its own");
  EXPECT_THAT(run.Refusal("swap", swap("leaning")), HasSubstr("it would see what the robot senses "
                                                              "instead of `base.up` (vec3)"));
  run.Request("load", {{"name", "shadow"}, {"file", PluginFile("seeing_more")}});
  EXPECT_THAT(run.Refusal("promote", {{"name", "shadow"}}), HasSubstr("`base.velocity.x`"));
  EXPECT_EQ(run.Request("swap", swap("seeing_too"))["task"], "seeing_too");
  run.Request("resume", {{"episodes", 4}});
  run.WaitUntilDone();
  EXPECT_EQ(EpisodesOf("run").back().active.task, 3);
}

TEST_F(ObservingTest, APromotedShadowIsWhatTheLearnerSees) {
  ASSERT_EQ(Train("run", 1), 0);
  const ServedRun run(Run("run"), [&] { return Resume("run", 2, LiveRun::WhenDone::kWait); });
  run.Request("load", {{"name", "shadow"}, {"file", PluginFile("seeing_too")}});
  run.Request("promote", {{"name", "shadow"}});
  run.Request("resume", {{"episodes", 3}});
  run.WaitUntilDone();
  run.Request("unload", {{"name", "task"}});  // nobody sees it any more
  run.Request("resume", {{"episodes", 4}});
  run.WaitUntilDone();
  EXPECT_EQ(EpisodesOf("run").size(), 4u);
  const json list = run.Request("list", json::object());
  EXPECT_EQ(list["tasks"][0]["observations"][1]["name"], "lean");
  EXPECT_EQ(list["tasks"][0]["observations"][1]["first"], 3);
  EXPECT_EQ(list["tasks"][0]["observations"][1]["least"], -0.1);
}

TEST_F(ObservingTest, ATaskThatObservesNothingLeavesItToTheRobot) {
  task().task = PluginFile("leaning");
  ASSERT_EQ(Train("robot", 2), 0);
  task().task = PluginFile("seeing_the_robot");
  ASSERT_EQ(Train("task", 2), 0);
  EXPECT_THAT(SeenIn("task"), Pointwise(DoubleNear(1e-6), SeenIn("robot")));
}

}  // namespace
}  // namespace runtime
