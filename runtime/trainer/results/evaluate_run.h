// A run's last checkpoint, put to the test in a profile.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "runtime/training/run/module_types.h"
#include "runtime/training/run/policy_evaluation.h"
#include "runtime/training/run/progress.h"
#include "runtime/training/run/stop_request.h"

namespace runtime {

struct EvaluationPlan {
  std::string profile;
  int64_t episodes = 3;
};

// Whether the run has learned anything that is saved. Throws UserError where there is no run.
bool HasCheckpoint(const std::filesystem::path& run);

// The evaluation that is there already, if it is what EvaluateRun() would find: of the last
// checkpoint, as many episodes, by this version of the trainer. Throws UserError as HasCheckpoint.
std::optional<PolicyEvaluation> FindEvaluation(const std::filesystem::path& run,
                                               const EvaluationPlan& plan);

// Lets what the run in `folder` had learned at its last checkpoint act in the plan's profile,
// without learning on, and writes the evaluation to that folder. It may be in training: its record
// is only read. Nothing if a stop was requested. `types`: what the agent's modules can be made of.
// Throws UserError.
std::optional<PolicyEvaluation> EvaluateRun(const std::filesystem::path& folder,
                                            const EvaluationPlan& plan, ProgressStyle style,
                                            const StopRequest& stop,
                                            const ModuleTypes& types = ProgramModuleTypes());

}  // namespace runtime
