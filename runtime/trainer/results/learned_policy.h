#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "runtime/analysis/export/policy.h"
#include "runtime/trainer/results/learned_run.h"
#include "runtime/training/run/module_types.h"

namespace runtime {

// What a run had learned at its last checkpoint, as other programs can do it.
class LearnedPolicy {
 public:
  // The run may be in training: its record is only read. Throws UserError where its policy depends
  // on more than what is observed, or is not finite.
  explicit LearnedPolicy(const std::filesystem::path& folder,
                         const ModuleTypes& types = ProgramModuleTypes());

  const ExportedPolicy& exported() const { return exported_; }

  // An episode of it in the profile that it was learned in, decision by decision, as
  // comma-separated values: "time [s]", then "observation/NAME [UNIT]", "action/NAME", with a
  // motion "joint_offsets/NAME [rad]", and "joint_targets/NAME [rad]".
  std::string RunEpisode();

 private:
  std::vector<Port*> ResultPorts() const;

  std::unique_ptr<Performer> performer_;
  Module* action_space_ = nullptr;
  ExportedPolicy exported_;
};

}  // namespace runtime
