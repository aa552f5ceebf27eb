// The agent files that come with the project. That they build and learn is shown by the tests of
// runs.
#include <gtest/gtest.h>

#include <filesystem>

#include "runtime/core/agent/agent.h"

namespace runtime {
namespace {

Agent HumanoidAgent() { return ReadAgent(ROBOTS_FOLDER "/humanoid/agent.toml", {}); }

// What a parameter is set to, as text.
std::string Setting(const Agent& agent, const std::string& module, const std::string& parameter) {
  for (const ModuleSetting& setting : agent.modules) {
    for (const ParameterSetting& candidate : setting.parameters) {
      if (setting.name == module && candidate.name == parameter) return ToText(candidate.value);
    }
  }
  return "not set";
}

size_t IndexOf(const Agent& agent, const std::string& first, const std::string& second) {
  for (size_t i = 0; i < agent.connections.size(); ++i) {
    const ConnectionSetting& connection = agent.connections[i];
    if (connection.first == first && connection.second == second) return i;
  }
  ADD_FAILURE() << first << " is not connected to " << second;
  return 0;
}

TEST(HumanoidAgent, HasThePublishedParameters) {
  const Agent agent = HumanoidAgent();
  EXPECT_EQ(Setting(agent, "state", "dof"), "\"5\"");
  EXPECT_EQ(Setting(agent, "features", "net"), "\"bq01\"");
  EXPECT_EQ(Setting(agent, "action_space", "intervals"), "[0.075, 0.1, 0.2]");
  EXPECT_EQ(Setting(agent, "learner", "discount"), "0.9");
  EXPECT_EQ(Setting(agent, "learner", "trace_decay"), "0.9");
  EXPECT_EQ(Setting(agent, "learner", "temperature"), "5.0");
  EXPECT_EQ(Setting(agent, "learner", "temperature_decay"), "0.004");
}

TEST(HumanoidAgent, PaysBeforeItLearns) {
  const Agent agent = HumanoidAgent();
  const auto expect_before = [&](const char* signal, const char* first, const char* second) {
    EXPECT_LT(IndexOf(agent, signal, first), IndexOf(agent, signal, second)) << signal;
  };
  expect_before("environment.start_of_episode", "task.on_start_of_episode",
                "learner.start_of_episode");
  expect_before("environment.start_of_time_step", "task.on_start_of_time_step",
                "action_space.start_of_time_step");
  expect_before("environment.end_of_time_step", "task.on_end_of_time_step",
                "action_space.end_of_time_step");
  expect_before("action_space.end_of_action", "task.on_end_of_action", "learner.end_of_action");
}

TEST(HumanoidAgent, CanBeChangedByTheAgentFileOfEachTask) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(TASKS_FOLDER)) {
    if (!entry.path().string().ends_with(".agent.toml")) continue;
    const Agent changes = ReadAgent(entry.path(), ROBOTS_FOLDER "/humanoid");
    const Agent agent = Changed(HumanoidAgent(), changes);
    EXPECT_EQ(agent.modules.size(), HumanoidAgent().modules.size()) << entry.path();
    for (const ModuleSetting& module : changes.modules) {
      for (const ParameterSetting& parameter : module.parameters) {
        EXPECT_EQ(Setting(agent, module.name, parameter.name), ToText(parameter.value));
      }
    }
    ++count;
  }
  EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace runtime
