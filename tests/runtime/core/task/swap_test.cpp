// Another task in a task module, and tasks that are evaluated beside the active one.
#include <gmock/gmock.h>

#include <sstream>

#include "runtime/core/module/module_graph.h"
#include "runtime/core/task/universal_task.h"
#include "tests/runtime/core/task/fake_modules.h"
#include "tests/runtime/core/task/test_plugins.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class SwapTest : public testing::Test {
 protected:
  SwapTest() {
    auto environment = std::make_unique<FakeEnvironment>(robot_);
    environment_ = environment.get();
    graph_.Add(std::move(environment));
    task_ = &AddTask("task", "walking");
    task_->reward.Connect(learner_.reward);
    task_->end_of_episode.Connect(learner_.end);
    environment_->values("base.velocity") = {3, 0, 0};
    environment_->values("base.up") = {0, 0, 1};
    environment_->values("base.position") = {0, 0, 2};
  }

  UniversalTask& AddTask(const std::string& name, const std::string& plugin) {
    auto task = std::make_unique<UniversalTask>(name, robot_, Instance(plugin, 1));
    UniversalTask& added = *task;
    graph_.Add(std::move(task));
    graph_.Connect("environment.*", name + ".*");
    return added;
  }

  std::unique_ptr<TaskInstance> Instance(const std::string& plugin, int64_t id) {
    return std::make_unique<TaskInstance>(LoadTask(plugin), id);
  }

  std::vector<std::string> Sensors() {
    std::vector<std::string> names;
    for (const Port* port : task_->ports()) {
      if (port->kind() == PortKind::kIn) names.push_back(port->name());
    }
    return names;
  }

  std::vector<double> TakeRewards() { return std::exchange(learner_.rewards, {}); }

  robot::RobotDescription robot_ = Walker();
  FakeLearner learner_;
  ModuleGraph graph_;
  FakeEnvironment* environment_;
  UniversalTask* task_;
};

TEST_F(SwapTest, ANewTaskPaysThroughTheSameModule) {
  task_->on_start_of_episode();
  task_->on_end_of_episode({});
  TakeRewards();
  task_->Swap(Instance("strolling", 2), graph_);
  EXPECT_EQ(task_->instance().id(), 2);
  task_->on_start_of_episode();
  task_->on_end_of_time_step(0.5);
  EXPECT_THAT(TakeRewards(), ElementsAre(1.25));
  EXPECT_THAT(task_->term_sums(), ElementsAre(0, 1.25));
}

TEST_F(SwapTest, SensorsComeAndGoWithTheTask) {
  Port* velocity = &task_->FindPort("base.velocity");
  task_->Swap(Instance("strolling", 2), graph_);
  EXPECT_THAT(Sensors(), testing::UnorderedElementsAre("base.velocity", "base.up"));
  EXPECT_EQ(&task_->FindPort("base.velocity"), velocity);  // with whatever it is connected to
  EXPECT_NO_THROW(task_->Start());
  EXPECT_THAT(environment_->FindPort("contact").Connections(), IsEmpty());
}

TEST_F(SwapTest, BetweenEpisodesOnlyTheMemoryOfTheRunIsTakenOver) {
  task_->on_start_of_episode();
  task_->on_end_of_time_step(0.5);  // pays 2 * 3 * 0.5
  task_->on_end_of_episode({});
  task_->Swap(Instance("strolling", 2), graph_);
  TakeRewards();
  task_->on_start_of_episode();
  task_->on_end_of_action();
  // speed 7, kept of another type 8, bonus 4, paid 0, 101 episodes
  EXPECT_THAT(TakeRewards(), ElementsAre(7 + 80 + 400 + 0 + 101e6));
}

TEST_F(SwapTest, InTheMiddleOfAnEpisodeEverythingGoesOn) {
  task_->on_start_of_episode();
  task_->on_end_of_time_step(0.5);
  task_->Swap(Instance("strolling", 2), graph_);
  EXPECT_THAT(task_->term_sums(), ElementsAre(3, 0));  // `forward` and `stroll`
  TakeRewards();
  task_->on_end_of_action();
  EXPECT_THAT(TakeRewards(), ElementsAre(7 + 80 + 400 + 3000 + 101e6));
  task_->on_end_of_time_step(0.5);
  task_->on_end_of_episode({});
  EXPECT_THAT(task_->metrics(), ElementsAre(1, 1.5));  // `steps` since the swap; `height` of both
}

TEST_F(SwapTest, ParamsThatWereSetKeepTheirValue) {
  task_->Set("gain", 40.0);
  task_->Swap(Instance("strolling", 2), graph_);
  EXPECT_EQ(task_->Get("gain"), ParameterValue(40.0));
  EXPECT_EQ(task_->Get("bonus"), ParameterValue(int64_t{4}));  // was not set: the new initial value
  task_->on_start_of_episode();
  task_->on_end_of_time_step(0.5);
  EXPECT_THAT(TakeRewards(), ElementsAre(41));
}

TEST_F(SwapTest, AParamThatDoesNotFitBeginsAnew) {
  task_->Set("gain", 60.0);    // more than the other task allows
  task_->Set("strict", true);  // a real there
  task_->Swap(Instance("strolling", 2), graph_);
  EXPECT_EQ(task_->Get("gain"), ParameterValue(0.25));
  EXPECT_EQ(task_->Get("strict"), ParameterValue(0.0));
}

TEST_F(SwapTest, RollbackGoesBackAndForth) {
  task_->Set("strict", true);
  task_->Swap(Instance("strolling", 2), graph_);
  task_->Set("gain", 40.0);
  task_->Rollback(graph_);
  EXPECT_EQ(task_->instance().id(), 1);
  EXPECT_STREQ(task_->plugin().name, "walking");
  EXPECT_EQ(task_->Get("gain"), ParameterValue(40.0));  // set meanwhile
  EXPECT_EQ(task_->Get("strict"), ParameterValue(true));
  EXPECT_NO_THROW(task_->Start());
  task_->Rollback(graph_);
  EXPECT_STREQ(task_->plugin().name, "strolling");
}

TEST_F(SwapTest, ThereIsNoRollbackBeforeASwap) {
  EXPECT_EQ(MessageOf([&] { task_->Rollback(graph_); }),
            "`task` has no previous task: it has not been swapped yet");
}

TEST_F(SwapTest, ATaskThatDoesNotFitChangesNothing) {
  EXPECT_EQ(MessageOf([&] { task_->Swap(Instance("other_robot", 2), graph_); }),
            "test.task: the task `test` is for the robot `snake`, and this run has the robot "
            "`walker`");
  graph_.Remove("environment");
  EXPECT_EQ(MessageOf([&] { task_->Swap(Instance("strolling", 2), graph_); }),
            "the task `strolling` reads the sensor `base.up`, and no module has an out port "
            "`base.up` of the type `vec3`");
  EXPECT_STREQ(task_->plugin().name, "walking");
  EXPECT_EQ(task_->previous(), nullptr);
}

// A module that is no environment, and offers one sensor.
class Ball : public Module {
 public:
  Ball() : Module("toy") {}
  double place[3] = {4, 5, 6};

 private:
  SensorData data_{place};
  SensorOut out_{this, "ball.position", &data_, "vec3 [m]"};
};

TEST_F(SwapTest, ASensorThatNoRobotHasComesFromWhateverModuleOffersIt) {
  const std::string message = MessageOf([&] { task_->Swap(Instance("own_sensor", 2), graph_); });
  EXPECT_THAT(message, testing::StartsWith(
                           "the task `test` reads the sensor `ball.position`, and no module has "
                           "an out port `ball.position` of the type `vec3 [m]`\n  help: add one to "
                           "the agent file:\n    [modules.ball_position]\n"));
  EXPECT_THAT(message, testing::HasSubstr("module add SignalGenerator ball_position "
                                          "sensor=ball.position shape=vec3 'unit=m'"));
  graph_.Add(std::make_unique<Ball>());
  task_->Swap(Instance("own_sensor", 2), graph_);
  TakeRewards();
  task_->on_start_of_episode();
  task_->on_end_of_time_step(0.5);
  EXPECT_THAT(TakeRewards(), ElementsAre(4));
}

TEST_F(SwapTest, AThousandSwapsLeaveOnlyTwoTasksLoaded) {
  std::vector<std::weak_ptr<const Plugin>> plugins;
  for (int i = 0; i < 1000; ++i) {
    auto next = Instance(i % 2 == 0 ? "strolling" : "walking", i);
    plugins.push_back(next->plugin());
    task_->Swap(std::move(next), graph_);
  }
  EXPECT_EQ(std::ranges::count_if(plugins, [](const auto& plugin) { return !plugin.expired(); }),
            2);
}

TEST_F(SwapTest, ACheckpointKeepsThePreviousTaskToo) {
  task_->Set("strict", true);
  task_->Swap(Instance("strolling", 2), graph_);
  task_->Set("gain", 40.0);
  std::stringstream checkpoint;
  task_->Save(checkpoint);

  UniversalTask& resumed = AddTask("resumed", "walking");
  resumed.Swap(Instance("strolling", 2), graph_);
  resumed.Load(checkpoint);
  EXPECT_EQ(resumed.Get("gain"), ParameterValue(40.0));
  resumed.Rollback(graph_);
  EXPECT_EQ(resumed.Get("strict"), ParameterValue(true));
}

TEST_F(SwapTest, AShadowSaysWhatTheActiveTaskWouldHaveSaid) {
  UniversalTask& shadow = AddTask("shadow", "walking");
  shadow.SetRole(UniversalTask::Role::kShadowEndsWithAction);
  for (UniversalTask* each : {task_, &shadow}) {
    each->on_start_of_episode();
    each->on_start_of_action();
    each->on_end_of_time_step(0.5);
    each->on_end_of_action();
    each->on_end_of_episode({EndKind::kDiverged, "diverged"});
  }
  EXPECT_THAT(TakeRewards(), ElementsAre(0, 0, 3, 3));  // the shadow's are connected to nothing
  EXPECT_EQ(shadow.episode_return(), task_->episode_return());
  EXPECT_EQ(shadow.end().reason, "diverged");
  EXPECT_EQ(shadow.end().kind, EndKind::kDiverged);
  EXPECT_TRUE(std::ranges::equal(shadow.term_sums(), task_->term_sums()));
}

TEST_F(SwapTest, AShadowEndsItsOwnEpisodeWithTheAction) {
  UniversalTask& shadow = AddTask("shadow", "walking");
  shadow.SetRole(UniversalTask::Role::kShadowEndsWithAction);
  environment_->values("base.velocity") = {20, 0, 0};
  shadow.on_start_of_episode();
  shadow.on_end_of_time_step(0.5);  // pays 20: far enough
  shadow.on_end_of_time_step(0.5);  // still the same action
  EXPECT_FALSE(shadow.has_ended());
  shadow.on_end_of_action();
  EXPECT_TRUE(shadow.has_ended());
  EXPECT_EQ(shadow.episode_return(), 43);  // with the bonus at the end
  shadow.on_end_of_time_step(0.5);
  shadow.on_end_of_episode({});
  EXPECT_EQ(shadow.episode_return(), 43);
  EXPECT_EQ(shadow.end().kind, EndKind::kSuccess);
  EXPECT_EQ(shadow.end().reason, "far enough");
  shadow.on_start_of_episode();
  EXPECT_FALSE(shadow.has_ended());
}

TEST_F(SwapTest, AShadowOfACleanLearnerEndsAtOnce) {
  UniversalTask& shadow = AddTask("shadow", "walking");
  shadow.SetRole(UniversalTask::Role::kShadowEndsAtOnce);
  environment_->values("base.velocity") = {20, 0, 0};
  shadow.on_start_of_episode();
  shadow.on_end_of_time_step(0.5);
  EXPECT_TRUE(shadow.has_ended());
  EXPECT_EQ(shadow.episode_return(), 23);
}

TEST_F(SwapTest, ATaskSleepsUntilAnEpisodeStarts) {
  task_->on_start_of_action();
  task_->on_end_of_time_step(0.5);
  task_->on_end_of_episode({});
  EXPECT_THAT(TakeRewards(), IsEmpty());
  EXPECT_FALSE(task_->has_ended());
  task_->on_start_of_episode();
  EXPECT_THAT(TakeRewards(), ElementsAre(0));
}

}  // namespace
}  // namespace runtime
