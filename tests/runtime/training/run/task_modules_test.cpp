#include "runtime/training/run/task_modules.h"

#include <gmock/gmock.h>

#include "runtime/training/learning/peng_q_lambda.h"
#include "tests/runtime/core/task/fake_modules.h"
#include "tests/runtime/core/task/test_plugins.h"
#include "tests/runtime/training/run/error_of.h"

namespace runtime {
namespace {

using testing::ElementsAre;

class TaskModulesTest : public testing::Test {
 protected:
  UniversalTask& AddTask(const std::string& name, int64_t id) {
    return static_cast<UniversalTask&>(graph_.Add(std::make_unique<UniversalTask>(
        name, robot_, std::make_unique<TaskInstance>(LoadTask("walking"), id))));
  }
  TaskModules Find() { return FindTaskModules(graph_, learner_); }

  robot::RobotDescription robot_ = Walker();
  PengQLambda learner_{"learner", {.robot = &robot_, .task = {}, .seed = 1}};
  ModuleGraph graph_;
};

TEST_F(TaskModulesTest, WhoseRewardReachesTheLearnerIsActive) {
  UniversalTask& first = AddTask("first", 1);
  UniversalTask& second = AddTask("second", 2);
  Port::Connect(second.reward, learner_.FindPort("reward"));
  const TaskModules found = Find();
  EXPECT_EQ(found.active, &second);
  EXPECT_THAT(found.shadows, ElementsAre(&first));
  EXPECT_TRUE(first.is_shadow());
  EXPECT_FALSE(second.is_shadow());
}

TEST_F(TaskModulesTest, OfTwoThatPayTheFirstIsActive) {
  UniversalTask& first = AddTask("first", 1);
  UniversalTask& second = AddTask("second", 2);
  for (UniversalTask* task : {&second, &first}) {
    Port::Connect(task->reward, learner_.FindPort("reward"));
  }
  EXPECT_EQ(Find().active, &first);
  EXPECT_THAT(Find().shadows, ElementsAre(&second));
}

TEST_F(TaskModulesTest, SomebodyHasToPay) {
  FakeLearner other;
  AddTask("task", 1).reward.Connect(other.reward);
  EXPECT_EQ(ErrorOf([&] { Find(); }),
            "no task pays the learner: connect the `reward` of a task module to `learner.reward`, "
            "and its `end_of_episode` to `learner.end_of_episode`");
}

TEST_F(TaskModulesTest, AnEvaluationIsWhatTheTaskSaysOfItsEpisode) {
  FakeEnvironment environment(robot_);
  UniversalTask& task = AddTask("task", 7);
  for (Port* in : task.ports()) {
    if (in->kind() == PortKind::kIn) Port::Connect(environment.FindPort(in->name()), *in);
  }
  environment.values("base.velocity") = {3, 0, 55};  // the first requirement does not hold
  environment.values("time") = {0.5};
  task.on_start_of_episode();
  task.on_end_of_time_step(0.5);  // pays 2 * 3 * 0.5
  task.on_end_of_episode({EndKind::kFailure, "another end"});
  const Evaluation evaluation = EvaluationOf(task);
  EXPECT_EQ(evaluation.task, 7);
  EXPECT_EQ(evaluation.episode_return, 6);  // with 3 at the end
  EXPECT_EQ(evaluation.end_kind, "truncated");
  EXPECT_EQ(evaluation.end_reason, "requirement: not too fast");
  EXPECT_EQ(evaluation.faults, 0);
  EXPECT_EQ(evaluation.violations, 1);
  EXPECT_THAT(evaluation.terms, ElementsAre(3, 0, 3, 0));
  EXPECT_EQ(evaluation.metrics.front(), 0.5);
  EXPECT_THAT(evaluation.logs, ElementsAre(3, 3, 3, 3, 3));
}

}  // namespace
}  // namespace runtime
