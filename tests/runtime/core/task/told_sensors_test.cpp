// Sensors that a task declares itself, told as parameters.
#include "runtime/core/task/told_sensors.h"

#include <gmock/gmock.h>

#include <sstream>

#include "runtime/core/module/module_graph.h"
#include "runtime/core/task/universal_task.h"
#include "tests/runtime/core/task/fake_modules.h"
#include "tests/runtime/core/task/test_plugins.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A module that offers the wish.
class Wisher : public Module {
 public:
  Wisher() : Module("wisher") {}
  double wish = 0.5;
  SensorData data{&wish};
  SensorOut out{this, "wish", &data, "real [m/s]"};
};

class ToldSensorsTest : public testing::Test {
 protected:
  ToldSensorsTest() { task_ = MakeTask(); }

  std::unique_ptr<UniversalTask> MakeTask() {
    auto task = std::make_unique<UniversalTask>("task", robot_, Instance());
    task->reward.Connect(learner_.reward);
    return task;
  }
  std::unique_ptr<TaskInstance> Instance() {
    return std::make_unique<TaskInstance>(LoadTask("wished"), 1);
  }
  static void TellAll(UniversalTask& task) {
    task.Set("wish", 1.5);
    task.Set("flags", std::vector{1.0, 0.0});
    task.Set("count", int64_t{3});
    task.Set("ball.place", std::vector{7.0, 8.0, 0.25});
  }
  double Paid(UniversalTask& task) {
    learner_.rewards.clear();
    task.on_start_of_episode();
    task.on_end_of_time_step(0.005);
    return learner_.rewards.back();
  }

  robot::RobotDescription robot_ = Walker();
  FakeLearner learner_;
  std::unique_ptr<UniversalTask> task_;
};

TEST_F(ToldSensorsTest, ReachTheTaskWithoutAModule) {
  TellAll(*task_);
  task_->Start();
  EXPECT_EQ(Paid(*task_), 1.5 + 10 + 300 + 0.25);
  task_->Set("flags", std::vector{1.0, 1.0});
  task_->Set("wish", int64_t{-1});
  EXPECT_EQ(Paid(*task_), -1 + 20 + 300 + 0.25);
  EXPECT_EQ(task_->Get("ball.place"), ParameterValue(std::vector{7.0, 8.0, 0.25}));
}

TEST_F(ToldSensorsTest, AreParametersWithUnitAndRange) {
  const Parameter& wish = task_->FindParameter("wish");
  EXPECT_EQ(wish.unit, "m/s");
  EXPECT_EQ(wish.minimum, -1);
  EXPECT_EQ(wish.maximum, 2);
  EXPECT_EQ(task_->Get("wish"), ParameterValue(std::vector<double>()));
}

TEST_F(ToldSensorsTest, OfWhichOneIsMissingKeepTheTaskFromStarting) {
  task_->Set("wish", 1.0);
  EXPECT_THAT(MessageOf([&] { task_->Start(); }),
              testing::AllOf(HasSubstr("reads the sensor `flags`"),
                             HasSubstr("or tell it a value: --set 'task.flags=[0, 0]'")));
}

TEST_F(ToldSensorsTest, ThatDoNotFitAreRefused) {
  const auto refusal = [&](const char* sensor, const ParameterValue& value) {
    return MessageOf([&] { task_->Set(sensor, value); });
  };
  EXPECT_EQ(refusal("wish", std::vector{1.0, 2.0}),
            "`task.wish` is a `real [m/s]` with 1 element, not 2");
  EXPECT_EQ(refusal("wish", 3.0), "`task.wish` must lie in -1 .. 2, and 3 does not");
  EXPECT_EQ(refusal("wish", std::string("fast")),
            "`task.wish` is a `real [m/s]`, and \"fast\" is not one");
  EXPECT_EQ(refusal("flags", true), "`task.flags` is a `bool[2]` with 2 elements, not 1");
  EXPECT_EQ(refusal("flags", std::vector{0.0, 2.0}),
            "`task.flags` is made of conditions, 0 or 1, and 2 is neither");
  EXPECT_EQ(refusal("count", 1.5), "`task.count` is made of whole numbers, and 1.5 is not one");
  EXPECT_EQ(refusal("ball.place", 1.0), "`task.ball.place` is a `vec3 [m]` with 3 elements, not 1");
  for (const char* sensor : {"wish", "flags", "count", "ball.place"})
    EXPECT_EQ(task_->Get(sensor), ParameterValue(std::vector<double>())) << sensor;
}

TEST_F(ToldSensorsTest, TakeTheLastWordOfValueAndConnection) {
  Wisher wisher;
  TellAll(*task_);
  Port& in = task_->FindPort("wish");
  Port::Connect(wisher.out, in);
  task_->NoteConnection();
  task_->Start();
  EXPECT_EQ(Paid(*task_), 0.5 + 10 + 300 + 0.25);
  EXPECT_EQ(task_->Get("wish"), ParameterValue(std::vector<double>()));
  task_->Set("wish", 1.0);
  EXPECT_THAT(in.Connections(), IsEmpty());
  EXPECT_EQ(Paid(*task_), 1.0 + 10 + 300 + 0.25);
}

TEST_F(ToldSensorsTest, ComeBeforeAModuleThatNobodyHasConnected) {
  ModuleGraph graph;
  graph.Add(std::make_unique<Wisher>());
  graph.Add(MakeTask());
  auto& task = graph.FindAs<UniversalTask>("task");
  TellAll(task);
  graph.Start();
  EXPECT_EQ(Paid(task), 1.5 + 10 + 300 + 0.25);
}

TEST_F(ToldSensorsTest, StayWithASwap) {
  TellAll(*task_);
  task_->Start();
  const ModuleGraph graph;
  task_->Swap(Instance(), graph);
  EXPECT_EQ(Paid(*task_), 1.5 + 10 + 300 + 0.25);
  task_->Rollback(graph);
  EXPECT_EQ(Paid(*task_), 1.5 + 10 + 300 + 0.25);
}

TEST_F(ToldSensorsTest, AreInACheckpoint) {
  TellAll(*task_);
  std::stringstream checkpoint;
  task_->Save(checkpoint);
  const auto resumed = MakeTask();
  resumed->Load(checkpoint);
  resumed->Start();
  EXPECT_EQ(Paid(*resumed), 1.5 + 10 + 300 + 0.25);
}

}  // namespace
}  // namespace runtime
