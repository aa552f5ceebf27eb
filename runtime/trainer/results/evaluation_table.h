// What came out of evaluating runs, for a person.
#pragma once

#include <string>
#include <vector>

#include "runtime/training/run/policy_evaluation.h"

namespace runtime {

struct NamedEvaluation {
  std::string run;
  PolicyEvaluation evaluation;
};

// A head and one line for each of the runs, which are one at least and of one profile. Of a single
// one also its metrics:
//
//   run       learned  paper-tree  remains  ended
//   seed1       12.25       11.86     97 %  3 truncated
//     rolls      0.82        0.79     96 %
std::string EvaluationTable(const std::vector<NamedEvaluation>& evaluations);

}  // namespace runtime
