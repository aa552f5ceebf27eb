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

// In this order, later ones win: robot's agent.toml, agent file of the task (NAME.agent.toml beside
// NAME.task, if it is there), `file` ("": none), `profile` ("": none), `settings`.
struct AgentLayers {
  std::filesystem::path robot_file;
  std::filesystem::path task_file;  // .task or .so
  std::filesystem::path file;
  std::string profile;
  std::vector<std::string> settings;

  Agent Merge() const;
  // What `file` and `settings` set, with the values of `merged`; not what another layer has set
  // differently after them.
  std::vector<Setting> SettingsIn(const Agent& merged) const;
};

}  // namespace runtime
