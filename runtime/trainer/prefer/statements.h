// What the command line of `trainer prefer` states.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/command_line/command.h"
#include "runtime/analysis/study/results.h"

namespace runtime {

// Behaviors are named as on the command line (compared_behavior.h).
struct PreferStatements {
  std::string better;
  std::string worse;
  std::vector<std::string> order;  // the best first
  std::vector<std::string> equal;

  void AddTo(command_line::Command& command);
  bool empty() const { return better.empty() && order.empty() && equal.empty(); }
};

// Adds them to the preferences in `folder`, that of the study. Returns the experiment that they are
// about, nullptr where nothing is stated. `experiment`: the only one whose runs may be meant; ""
// for all. Throws CallError or UserError for a behavior that cannot be compared; then nothing is
// noted.
const ExperimentResult* NoteStatements(const PreferStatements& statements,
                                       const StudyResults& study, const std::string& experiment,
                                       const std::filesystem::path& folder);

}  // namespace runtime
