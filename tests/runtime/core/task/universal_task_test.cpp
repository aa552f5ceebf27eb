#include "runtime/core/task/universal_task.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "runtime/core/module/module_graph.h"
#include "tests/runtime/core/task/allocation_count.h"
#include "tests/runtime/core/task/fake_modules.h"
#include "tests/runtime/core/task/test_plugins.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsNan;
using testing::Pair;
using testing::UnorderedElementsAre;

class UniversalTaskTest : public testing::Test {
 protected:
  UniversalTaskTest() {
    context_.robot = &robot_;
    context_.task = LoadTask("walking");
    task_ = MakeTask("task");
  }

  std::unique_ptr<UniversalTask> MakeTask(const std::string& name) {
    auto task = std::make_unique<UniversalTask>(name, context_);
    for (Port* in : task->ports()) {
      if (in->kind() == PortKind::kIn) Port::Connect(environment_.FindPort(in->name()), *in);
    }
    task->reward.Connect(learner_.reward);
    task->end_of_episode.Connect(learner_.end);
    task->Start();
    return task;
  }

  std::vector<double> TakeRewards() { return std::exchange(learner_.rewards, {}); }

  robot::RobotDescription robot_ = Walker();
  Context context_;
  FakeEnvironment environment_{robot_};
  FakeLearner learner_;
  std::unique_ptr<UniversalTask> task_;
};

TEST_F(UniversalTaskTest, HasAnInPortForEachSensorOfThePlugin) {
  std::vector<std::string> names;
  for (const Port* port : task_->ports()) {
    if (port->kind() == PortKind::kIn) names.push_back(port->name() + " " + port->type().text);
  }
  EXPECT_THAT(names,
              ElementsAre("time real [s]", "base.position vec3 [m]", "base.velocity vec3 [m/s]",
                          "contact bool[link]", "joint.angle real[joint] [rad]"));
}

TEST_F(UniversalTaskTest, RefusesToStartWithASensorThatIsNotConnected) {
  Port& in = task_->FindPort("base.velocity");
  Port::Disconnect(in, *in.Connections().front());
  EXPECT_EQ(MessageOf([&] { task_->Start(); }),
            "`task.base.velocity` is not connected: connect it to an out port of the type `vec3 "
            "[m/s]`");
}

TEST_F(UniversalTaskTest, SaysWhatToAddForASensorThatNoRobotHas) {
  context_.task = LoadTask("own_sensor");
  UniversalTask task("task", context_);
  EXPECT_THAT(MessageOf([&] { task.Start(); }),
              testing::AllOf(testing::HasSubstr("reads the sensor `ball.position`"),
                             testing::HasSubstr("type = \"SignalGenerator\"")));
}

TEST_F(UniversalTaskTest, RefusesAPluginForAnotherRobot) {
  context_.task = LoadTask("other_robot");
  EXPECT_EQ(MessageOf([&] { UniversalTask("other", context_); }),
            "test.task: the task `test` is for the robot `snake`, and this run has the robot "
            "`walker`");
}

TEST_F(UniversalTaskTest, EventReadsOnlyItsOwnSensors) {
  task_->on_start_of_episode();
  EXPECT_THAT(environment_.TakeReads(), IsEmpty());
  task_->on_start_of_action();
  EXPECT_THAT(environment_.TakeReads(), UnorderedElementsAre(Pair("joint.angle", 1)));
  task_->on_end_of_physics_step(0.001);
  EXPECT_THAT(environment_.TakeReads(), IsEmpty());
  // The event itself reads velocity and contact, the metrics time and position.
  task_->on_end_of_time_step(0.005);
  EXPECT_THAT(environment_.TakeReads(),
              UnorderedElementsAre(Pair("base.position", 1), Pair("base.velocity", 1),
                                   Pair("contact", 1), Pair("time", 1)));
}

TEST_F(UniversalTaskTest, EventsWithoutAFunctionDoNothing) {
  task_->on_start_of_episode();
  TakeRewards();
  task_->on_end_of_action();
  task_->on_start_of_time_step(0.005);
  task_->on_start_of_physics_step(0.001);
  EXPECT_THAT(environment_.TakeReads(), IsEmpty());
  EXPECT_THAT(learner_.rewards, IsEmpty());
}

TEST_F(UniversalTaskTest, EventGetsSensorsParamsMemoryAndTimeStep) {
  environment_.values("base.velocity") = {3, 0, 0};
  environment_.values("joint.angle") = {0.125, 0.375};
  environment_.flags("contact")[2] = true;
  task_->on_start_of_episode();
  task_->on_start_of_action();
  task_->on_end_of_time_step(0.5);  // 2 * 3 * 0.5, and a fall
  task_->on_end_of_time_step(0.5);  // the fall is paid once for each action
  task_->on_start_of_action();
  task_->on_end_of_time_step(0.25);
  task_->on_end_of_physics_step(0.125);  // 0.125 + 100 + 1 episode
  EXPECT_THAT(TakeRewards(), ElementsAre(0, 0.5, 2, 3, 0.5, 0.5, 101.125));
  EXPECT_THAT(task_->term_sums(), ElementsAre(7.5, -2, 101.125, 1));
}

TEST_F(UniversalTaskTest, RewardOfZeroIsEmittedToo) {
  task_->on_start_of_episode();
  task_->on_end_of_time_step(0.5);
  EXPECT_THAT(TakeRewards(), ElementsAre(0, 0));
}

TEST_F(UniversalTaskTest, TermSumsStartAnewWithEachEpisode) {
  environment_.values("base.velocity") = {1, 0, 0};
  task_->on_start_of_episode();
  task_->on_end_of_time_step(0.5);
  task_->on_start_of_episode();
  EXPECT_THAT(task_->term_sums(), ElementsAre(0, 0, 0, 0));
  task_->on_end_of_time_step(0.25);
  EXPECT_THAT(task_->term_sums(), ElementsAre(0.5, 0, 0, 0));
}

TEST_F(UniversalTaskTest, EndComesAfterTheReward) {
  environment_.values("base.velocity") = {100, 0, 0};
  task_->on_start_of_episode();
  task_->on_end_of_time_step(0.5);
  EXPECT_THAT(learner_.ends, ElementsAre(Pair(EndKind::kSuccess, "far enough")));
  EXPECT_EQ(learner_.rewards_before_end, 2u);
}

TEST_F(UniversalTaskTest, FirstEndOfAnEpisodeWins) {
  environment_.values("base.velocity") = {0, 6, 0};
  task_->on_start_of_episode();
  task_->on_end_of_time_step(0.5);
  environment_.values("base.velocity") = {100, 0, 0};
  task_->on_end_of_time_step(0.5);  // the episode goes on to the end of its action
  task_->on_end_of_episode({});
  EXPECT_THAT(learner_.ends, ElementsAre(Pair(EndKind::kFailure, "too fast")));
  task_->on_start_of_episode();
  task_->on_end_of_time_step(0.5);
  EXPECT_THAT(learner_.ends, ElementsAre(Pair(EndKind::kFailure, "too fast"),
                                         Pair(EndKind::kSuccess, "far enough")));
}

TEST_F(UniversalTaskTest, LimitIsNoTerminalEnd) {
  task_->Set("strict", true);
  environment_.flags("contact")[2] = true;
  task_->on_start_of_episode();
  task_->on_end_of_time_step(0.5);
  EXPECT_THAT(learner_.ends, ElementsAre(Pair(EndKind::kTruncated, "time is up")));
}

TEST_F(UniversalTaskTest, EndInTheEventAtTheEndIsNotEmitted) {
  task_->on_start_of_episode();
  task_->on_end_of_episode({});
  EXPECT_THAT(learner_.ends, IsEmpty());
  EXPECT_THAT(TakeRewards(), ElementsAre(0, 3));
}

TEST_F(UniversalTaskTest, EpisodeEndsOnce) {
  task_->on_start_of_episode();
  task_->on_end_of_episode({});
  task_->on_end_of_episode({});
  EXPECT_THAT(TakeRewards(), ElementsAre(0, 3));
}

TEST_F(UniversalTaskTest, MetricsAreReducedOverTheTimeSteps) {
  task_->on_start_of_episode();
  for (const double height : {0.5, 2.0, -1.0, 0.5}) {
    environment_.values("base.position") = {0, 0, height};
    environment_.values("time")[0] += 0.25;
    task_->on_end_of_time_step(0.25);
  }
  environment_.values("time")[0] = 1.5;
  environment_.values("base.position") = {0, 0, 99};  // after the last step: only `last` sees it
  task_->on_end_of_episode({});
  EXPECT_THAT(task_->metrics(), ElementsAre(1.5, 2, 2, -1, 0.5));
}

TEST_F(UniversalTaskTest, LogsAreReducedOverTheirStatements) {
  for (int episode = 0; episode < 2; ++episode) {
    task_->on_start_of_episode();
    for (const double speed : {2.0, -1.0, 0.5, 0.5}) {  // the second is not logged
      environment_.values("base.velocity") = {speed, 0, 0};
      task_->on_end_of_time_step(0.25);
    }
    task_->on_end_of_episode({});
    EXPECT_THAT(task_->logs(), ElementsAre(0.5, 3, 2, 0.5, 1));
  }
}

TEST_F(UniversalTaskTest, LogThatNothingWasWrittenToIsNoNumber) {
  task_->on_start_of_episode();
  task_->on_end_of_episode({});
  EXPECT_THAT(task_->logs(), ElementsAre(IsNan(), 0, IsNan(), IsNan(), IsNan()));
}

TEST_F(UniversalTaskTest, RequirementThatDoesNotHoldEndsTheEpisodeAsTruncated) {
  environment_.values("base.velocity") = {100, 6, 55};  // `far enough` and `too fast` as well
  task_->on_start_of_episode();
  task_->on_end_of_time_step(0.5);
  EXPECT_THAT(TakeRewards(), ElementsAre(0, 100));  // what the event pays counts
  task_->on_end_of_time_step(0.5);
  EXPECT_THAT(learner_.ends, ElementsAre(Pair(EndKind::kTruncated, "requirement: not too fast")));
  ASSERT_EQ(task_->violations().size(), 2u);
  EXPECT_EQ(task_->violations()[0].count, 2);
  EXPECT_EQ(task_->violations()[0].first_time, 0.5);
  EXPECT_EQ(task_->violations()[1].count, 0);
  task_->on_start_of_episode();
  EXPECT_EQ(task_->violations()[0].count, 0);
}

TEST_F(UniversalTaskTest, FirstOfTwoRequirementsIsTheReason) {
  environment_.values("base.velocity") = {0, 0, 70};
  task_->on_start_of_episode();
  task_->on_end_of_time_step(0.5);
  EXPECT_EQ(task_->violations()[0].count, 1);
  EXPECT_EQ(task_->violations()[1].count, 0);
}

TEST_F(UniversalTaskTest, StepThatEndsTheEpisodeBelongsToTheMetrics) {
  learner_.on_end = [&] { task_->on_end_of_episode({}); };  // a learner that ends at once
  environment_.values("base.velocity") = {0, 6, 0};
  environment_.values("base.position") = {0, 0, 4};
  task_->on_start_of_episode();
  task_->on_end_of_time_step(0.5);
  EXPECT_THAT(task_->metrics(), ElementsAre(0, 4, 4, 4, 4));
  task_->on_end_of_time_step(0.5);
  EXPECT_THAT(task_->metrics(), ElementsAre(0, 4, 4, 4, 4));
}

TEST_F(UniversalTaskTest, EventDuringAnEmissionDoesNotChangeItsEnd) {
  task_->on_start_of_episode();
  // The reward's receiver starts another event of the same task before the end is emitted.
  learner_.on_reward = [&] {
    learner_.on_reward = nullptr;
    task_->on_end_of_physics_step(0.5);
  };
  environment_.values("base.velocity") = {0, 6, 0};
  task_->on_end_of_time_step(0.5);
  EXPECT_THAT(learner_.ends, ElementsAre(Pair(EndKind::kFailure, "too fast")));
}

TEST_F(UniversalTaskTest, ValueThatIsNotFiniteIsNotPaidButCounted) {
  task_->on_start_of_episode();
  TakeRewards();
  task_->on_end_of_time_step(0.5);
  environment_.values("base.velocity") = {std::nan(""), 0, 0};
  environment_.flags("contact")[2] = true;
  task_->on_end_of_time_step(0.5);
  environment_.values("base.velocity") = {std::numeric_limits<double>::infinity(), 0, 0};
  task_->on_end_of_time_step(0.5);
  EXPECT_THAT(TakeRewards(), ElementsAre(0, -1, 0));
  EXPECT_EQ(task_->fault_count(), 2);
  EXPECT_EQ(task_->faults()[0].count, 2);
  EXPECT_EQ(task_->faults()[0].first_time, 1.0);
  EXPECT_EQ(task_->faults()[1].count, 0);
  task_->on_start_of_episode();
  EXPECT_EQ(task_->fault_count(), 0);
  EXPECT_EQ(task_->faults()[0].count, 0);
}

TEST_F(UniversalTaskTest, SumOfFiniteTermsThatIsNotFiniteIsNotPaidButCounted) {
  const double largest = std::numeric_limits<double>::max();
  environment_.values("joint.angle") = {largest, largest};
  task_->on_start_of_episode();
  task_->on_start_of_action();
  EXPECT_THAT(TakeRewards(), ElementsAre(0, 0));
  EXPECT_EQ(task_->fault_count(), 1);
}

TEST_F(UniversalTaskTest, SumOfAnEventThatIsTooLargeIsNotPaidSoThatNoReturnOverflows) {
  environment_.values("joint.angle") = {0.75e30, 0};
  task_->on_start_of_episode();
  task_->on_start_of_action();
  EXPECT_EQ(task_->episode_return(), 0.75e30);
  environment_.values("joint.angle") = {-0.75e30, -0.75e30};
  task_->on_start_of_action();
  EXPECT_THAT(TakeRewards(), ElementsAre(0, 0.75e30, 0));
  EXPECT_EQ(task_->episode_return(), 0.75e30);
  EXPECT_EQ(task_->fault_count(), 1);
}

TEST_F(UniversalTaskTest, ParamsAreTheModulesParameters) {
  EXPECT_EQ(task_->Get("gain"), ParameterValue(2.0));
  EXPECT_EQ(task_->Get("bonus"), ParameterValue(int64_t{3}));
  EXPECT_EQ(task_->Get("strict"), ParameterValue(false));
  task_->Set("gain", int64_t{5});
  task_->Set("bonus", int64_t{-4});
  environment_.values("base.velocity") = {1, 0, 0};
  task_->on_start_of_episode();
  task_->on_end_of_time_step(1);
  task_->on_end_of_episode({});
  EXPECT_THAT(TakeRewards(), ElementsAre(0, 5, -4));
}

TEST_F(UniversalTaskTest, ParamsAreChecked) {
  EXPECT_EQ(MessageOf([&] { task_->Set("gian", 1.0); }),
            "the module `task` has no parameter `gian`: did you mean `gain`?");
  EXPECT_EQ(MessageOf([&] { task_->Set("gain", -1.0); }),
            "`task.gain` must lie in 0 .. 1000, and -1 does not");
  EXPECT_EQ(MessageOf([&] { task_->Set("bonus", 1.5); }),
            "`task.bonus` is an integer, and 1.5 is not one");
  EXPECT_EQ(MessageOf([&] { task_->Set("strict", 1.0); }),
            "`task.strict` is true or false, and 1.0 is not one");
}

TEST_F(UniversalTaskTest, InstancesShareNoMemory) {
  const auto other = MakeTask("other");
  environment_.values("base.velocity") = {1, 0, 0};
  task_->Set("gain", 4.0);
  task_->on_start_of_episode();
  task_->on_start_of_episode();
  other->on_start_of_episode();
  TakeRewards();
  task_->on_end_of_physics_step(0);
  other->on_end_of_physics_step(0);
  task_->on_end_of_time_step(1);
  other->on_end_of_time_step(1);
  EXPECT_THAT(TakeRewards(), ElementsAre(102, 101, 4, 2));
}

TEST_F(UniversalTaskTest, MemoryOfTheRunAndParamsSurviveACheckpoint) {
  environment_.values("base.velocity") = {1, 0, 0};
  task_->Set("gain", 7.0);
  task_->Set("bonus", int64_t{1});
  task_->on_start_of_episode();
  task_->on_end_of_time_step(1);
  task_->on_end_of_episode({});
  std::stringstream checkpoint;
  task_->Save(checkpoint);

  const auto resumed = MakeTask("task");
  resumed->Load(checkpoint);
  TakeRewards();
  for (UniversalTask* task : {task_.get(), resumed.get()}) {
    task->on_start_of_episode();
    task->on_end_of_time_step(1);
    task->on_end_of_physics_step(0);
    task->on_end_of_episode({});
  }
  EXPECT_THAT(TakeRewards(), ElementsAre(0, 7, 102, 1, 0, 7, 102, 1));
  std::stringstream again, of_resumed;
  task_->Save(again);
  resumed->Save(of_resumed);
  EXPECT_EQ(again.str(), of_resumed.str());
}

TEST_F(UniversalTaskTest, CheckpointOfAnotherTaskChangesOnlyWhatBothHave) {
  std::stringstream checkpoint;
  task_->Save(checkpoint);
  context_.task = LoadTask("empty");
  const auto other = MakeTask("task");
  EXPECT_NO_THROW(other->Load(checkpoint));

  std::stringstream of_other;
  other->Save(of_other);
  task_->on_start_of_episode();
  task_->Load(of_other);
  task_->on_end_of_physics_step(0);
  EXPECT_EQ(learner_.rewards.back(), 101);
}

TEST_F(UniversalTaskTest, CheckpointThatIsCutOffIsRefused) {
  std::stringstream checkpoint;
  task_->Save(checkpoint);
  const std::string whole = checkpoint.str();
  for (size_t size = 0; size < whole.size(); ++size) {
    std::istringstream cut(whole.substr(0, size));
    ASSERT_THROW(task_->Load(cut), UserError) << "cut at " << size;
  }
}

TEST_F(UniversalTaskTest, AnEpisodeAllocatesNothing) {
  const auto run_episode = [&] {
    task_->on_start_of_episode();
    for (int action = 0; action < 10; ++action) {
      task_->on_start_of_action();
      for (int step = 0; step < 20; ++step) {
        task_->on_start_of_time_step(0.005);
        task_->on_start_of_physics_step(0.001);
        task_->on_end_of_physics_step(0.001);
        task_->on_end_of_time_step(0.005);
      }
      task_->on_end_of_action();
    }
    task_->on_end_of_episode({});
  };
  const int64_t before = AllocationCount();
  run_episode();
  EXPECT_EQ(AllocationCount(), before);
}

TEST_F(UniversalTaskTest, MetricsKnowTheTimeStepWithoutAnEventAtItsEnd) {
  context_.task = LoadTask("measuring");
  const auto task = MakeTask("measuring");
  task->on_start_of_episode();
  for (int step = 0; step < 2; ++step) {
    task->on_end_of_physics_step(0.125);
    task->on_end_of_time_step(0.25);
  }
  task->on_end_of_physics_step(0.125);
  task->on_end_of_episode({});
  EXPECT_THAT(task->metrics(), ElementsAre(0.5, 0.25));
}

TEST_F(UniversalTaskTest, PluginWithoutAnythingRuns) {
  context_.task = LoadTask("empty");
  const auto empty = MakeTask("empty");
  TakeRewards();
  empty->on_start_of_episode();
  empty->on_end_of_time_step(0.005);
  empty->on_end_of_episode({});
  EXPECT_THAT(learner_.rewards, IsEmpty());
  EXPECT_THAT(empty->metrics(), IsEmpty());
}

}  // namespace
}  // namespace runtime
