#include "runtime/training/run/graph_copy.h"

#include <gmock/gmock.h>

#include <fstream>

#include "runtime/core/module/graph_text.h"
#include "runtime/trainer/setup/task_setup.h"
#include "runtime/training/run/task_modules.h"
#include "tests/runtime/trainer/learner_run.h"

namespace runtime {
namespace {

using testing::HasSubstr;
using testing::Not;

class GraphCopyTest : public testing::Test {
 protected:
  // A graph as a run of this agent has it.
  TaskSetup Setup(const std::string& agent, const std::string& task = "swaying") const {
    return {{.task = PluginFile(task),
             .profile = "fast",
             .agent = agent,
             .robot = "humanoid",
             .settings = {}},
            PluginFile(task),
            5};
  }

  const ScopedEnvironment robots_{"TASKC_ROBOT_PATH", ROBOTS};
};

TEST_F(GraphCopyTest, HasTheSameModulesParametersAndConnectionsInTheirOrder) {
  const TemporaryFolder folder;
  const std::string nested = (folder.path() / "nested.toml").string();
  std::ofstream(nested) << "include = [\"" << ROBOTS << R"(/humanoid/ppo.agent.toml"]
[composites.Offsets]
ports = {execute = "inner.execute", end_of_time_step = "inner.end_of_time_step", end_of_action = "inner.end_of_action", action_size = "inner.action_size", joint_targets = "inner.joint_targets"}
parameters = {reach = "inner.scale"}
[composites.Offsets.modules.inner]
type = "JointOffsets"
hold = 5
[modules.action_space]
type = "Offsets"
reach = 0.75
)";
  for (const std::string& agent : {std::string("paper"), std::string("ppo"), nested}) {
    TaskSetup setup = Setup(agent);
    setup.graph.Start();
    const ModuleGraph copy = CopyOf(setup.graph, setup.types, setup.context);
    EXPECT_EQ(GraphText(copy), GraphText(setup.graph));
  }
}

TEST_F(GraphCopyTest, ATaskIsTheOneThatIsThereNow) {
  TaskSetup setup = Setup("ppo");
  setup.graph.Start();
  auto& task = setup.graph.FindOnly<UniversalTask>();
  task.Swap(
      std::make_unique<TaskInstance>(std::make_shared<const Plugin>(PluginFile("swaying_less")), 7),
      setup.graph);
  task.Set("gain", 4.0);
  task.HoldGoal(0, std::vector<double>{0.3});
  const ModuleGraph copy = CopyOf(setup.graph, setup.types, setup.context);
  const auto& same = copy.FindOnly<UniversalTask>();
  EXPECT_STREQ(same.plugin().name, "swaying_less");
  EXPECT_EQ(same.instance().id(), 7);
  EXPECT_EQ(same.instance().plugin(), task.instance().plugin());
  EXPECT_EQ(same.Get("gain"), ParameterValue(4.0));
  EXPECT_TRUE(same.instance().goals().IsHeld(0));
  EXPECT_EQ(same.instance().goals().Value(0), std::vector<double>{0.3});

  task.Set("gain", 1.0);
  CopyParameters(setup.graph, copy);
  EXPECT_EQ(same.Get("gain"), ParameterValue(1.0));
}

// It may be one that cannot be started yet.
TEST_F(GraphCopyTest, WhatNobodyHearsIsLeftOut) {
  TaskSetup setup = Setup("ppo");
  setup.graph.Start();
  setup.graph.Add(setup.types.Make("SignalGenerator", "silent", setup.context));
  const ModuleGraph copy = CopyOf(setup.graph, setup.types, setup.context);
  EXPECT_THAT(GraphText(copy), Not(HasSubstr("silent")));
}

TEST_F(GraphCopyTest, ATaskRemembersEpisodesWhereItsVariablesLastAsLongAsTheRun) {
  for (const char* name : {"leaning", "upright"}) {
    EXPECT_TRUE(Setup("ppo", name).graph.FindOnly<UniversalTask>().instance().remembers_episodes());
  }
  // Goals and starts are drawn anew.
  for (const char* name : {"seeing", "swaying", "swaying_less"}) {
    EXPECT_FALSE(
        Setup("ppo", name).graph.FindOnly<UniversalTask>().instance().remembers_episodes());
  }
}

}  // namespace
}  // namespace runtime
