// The recorded episodes of an experiment under other weights, as if they had gone the same way.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "runtime/analysis/study/results.h"

namespace runtime {

// Under the weights that the runs had, and under the new ones.
template <class Value>
struct BeforeAfter {
  Value before{};
  Value after{};
};

// Means over episodes; not numbers of a run without one, and of one that does not count.
struct RunReturns {
  std::optional<std::string> left_out;  // why, where the run does not count
  BeforeAfter<double> final;            // over the last ones
  BeforeAfter<double> all;
};

struct Rescored {
  std::vector<RunReturns> runs;             // in the order of the experiment's
  std::vector<BeforeAfter<double>> groups;  // mean final returns, in the order of the experiment's
  // What each of the task's terms pays at the end, a mean over the runs that are finished.
  std::vector<BeforeAfter<double>> terms;
};

// `factors`: by which what each term pays is multiplied. `left_out`: why runs do not count.
Rescored Rescore(const ExperimentResult& result, const Eigen::VectorXd& factors,
                 const std::vector<std::optional<std::string>>& left_out);

}  // namespace runtime
