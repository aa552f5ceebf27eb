// A run's graph as its folder keeps it, whatever became of the task's and the robot's files.
#pragma once

#include <filesystem>
#include <memory>

#include "plugins/robot/robot_description.h"
#include "runtime/core/agent/agent.h"
#include "runtime/core/module/context.h"
#include "runtime/core/module/module_graph.h"
#include "runtime/core/task/plugin.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

// What it learns by, with libraries called as they are in `folder`. Runs none of their code. Throws
// UserError where the record of it is damaged.
Agent AgentOfRun(const std::filesystem::path& folder, const RunRecord& run);

struct KeptRun {
  // `robot_folder`: gets the robot's description as a file. `program_types`: what the agent's
  // modules can be made of, besides its libraries and its own composites. Throws UserError where
  // something is gone or damaged.
  KeptRun(const std::filesystem::path& folder, const RunRecord& run,
          const std::filesystem::path& robot_folder, const ModuleTypes& program_types);
  KeptRun(const KeptRun&) = delete;
  KeptRun& operator=(const KeptRun&) = delete;

  std::shared_ptr<const Plugin> plugin;
  robot::RobotDescription robot;
  Context context;
  Agent agent;
  ModuleTypes types;
  ModuleGraph graph;  // not started
};

}  // namespace runtime
