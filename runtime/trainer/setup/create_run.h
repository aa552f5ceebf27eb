// A new run in its folder, ready to be trained by `trainer resume` or at once.
#pragma once

#include <cstdint>
#include <filesystem>

#include "base/command_line/command.h"
#include "runtime/trainer/setup/task_setup.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

// Where runs are that nobody has named a folder for.
inline constexpr const char* kRunsFolder = "runs";

// What a run is besides its task and agent.
struct RunPlan {
  int64_t episodes = 1000;
  uint64_t seed = 0;
  int64_t record_every = 50;
  double checkpoint_seconds = 60;

  void AddTo(command_line::Command& command);
};

// All that is stored about the run but its plugin. Throws UserError where the agent lacks what
// every run needs: one environment, one learner, one task that pays it.
RunRecord RecordOf(const TaskSetup& setup, const RunPlan& plan);

// Makes the folder, and in it the run with all that it needs to continue, whatever becomes of the
// task's and the robot's files. Completes `run`. Throws UserError where there is a run already.
RunDatabase CreateRun(const std::filesystem::path& folder, const TaskSetup& setup, RunRecord& run);

// The same for a run that another process will train, with the seed `seed`.
void PrepareRun(const std::filesystem::path& folder, const TaskSetup& setup, RunRecord run,
                uint64_t seed);

}  // namespace runtime
