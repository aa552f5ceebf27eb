// How a run's agent comes about: the robot's own agent file, and what changes it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/core/agent/agent.h"
#include "runtime/training/run/run_settings.h"

namespace runtime {

// One change from the command line, "learner.temperature=2", as a change of the agent. The value is
// written as in TOML; quotes around a text may be left out. Throws CallError.
Agent ParseSetting(const std::string& setting);

// In this order, later ones win: robot's agent.toml or, where it has none, kAgentOfAnyRobot, agent
// file of the task (NAME.agent.toml beside NAME.task, if it is there), `agent` as FindAgentFile()
// finds it ("": none), where that is one of the robot's what the task changes in it
// (NAME.AGENT.agent.toml beside NAME.task, if it is there), `profile` ("": none),
// `environment_socket` ("": none), `settings`.
struct AgentLayers {
  std::filesystem::path robot_folder;  // AgentsWithoutRobot() where there is none
  std::filesystem::path task_file;     // .task or .so
  std::string agent;
  std::string profile;
  std::string environment_socket;  // path of a SocketEnvironment
  std::vector<std::string> settings;

  // Throws UserError, or CallError where there is no such agent.
  Agent Merge() const;
  // The user's file, if `agent` is one, and `settings`. Throws as Merge() does.
  Agent Changes() const;
  // What `changes`, from Changes(), set, with the values of `merged`; not what another layer has
  // set differently after them.
  std::vector<Setting> SettingsIn(const Agent& merged, const Agent& changes) const;

 private:
  Agent Read(const std::filesystem::path& file) const;
  bool IsOfRobot(const SourcePlace& place) const;
  // Changes it by the file beside the task's with this extension, if it is there.
  void AddTaskFile(const std::string& extension, Agent& merged) const;
};

}  // namespace runtime
