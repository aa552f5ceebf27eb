// Behaviors that can be compared by what their reward terms paid.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "runtime/analysis/preference/preferences_file.h"
#include "runtime/analysis/study/results.h"

namespace runtime {

// Why the sums of a run's terms say nothing under other weights: they were not paid by one task
// with the same params throughout. Nothing where they do.
std::optional<std::string> WhyIncomparable(const StudyRun& run);

// The sums of the task's terms, in their order, in the behavior: of the episode, or the means over
// the last ones of a finished run. Throws UserError where there are none.
Eigen::VectorXd TermSums(const RunResult& run, const BehaviorName& behavior);

// The index of the run with this name.
std::optional<size_t> FindRun(const ExperimentResult& result, const std::string& name);

// Behaviors as a user names them, of one experiment: with the names of runs shortened where it is
// clear which is meant ("seed3"), which may follow from the other names. `experiment`: its name, or
// empty. Throws UserError where a name is of no run, or of several.
std::vector<BehaviorName> FindBehaviors(const std::vector<ExperimentResult>& experiments,
                                        const std::vector<std::string>& names,
                                        const std::string& experiment);

}  // namespace runtime
