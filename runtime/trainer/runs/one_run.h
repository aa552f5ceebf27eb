// One run, in this process: from its start, or from its last checkpoint.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "runtime/trainer/runs/run_session.h"
#include "runtime/trainer/setup/create_run.h"
#include "runtime/trainer/setup/task_setup.h"
#include "runtime/training/run/module_types.h"

namespace runtime {

// Both return the exit status, and throw UserError or CallError. `types`: what the agent's modules
// can be made of.

// `named_folder`: empty for runs/TASK-PROFILE-seedSEED.
int TrainOneRun(const TaskOptions& options, const RunPlan& plan,
                const std::filesystem::path& named_folder, const SessionOptions& session,
                const ModuleTypes& types = ProgramModuleTypes());

// `episodes`: how many the run is to have in all, if not as many as planned.
int ResumeOneRun(const std::filesystem::path& folder, std::optional<int64_t> episodes,
                 const SessionOptions& session, const ModuleTypes& types = ProgramModuleTypes());

// Sets how many episodes the run is to have. Returns whether there is something left to do.
bool PlanEpisodes(std::optional<int64_t> episodes, RunDatabase& database, RunRecord& run);

}  // namespace runtime
