// Which params are the weights of which reward terms: what a task's rewards can be re-weighted by,
// without running the robot again.
//
// A param is the weight of a term if all that the term ever pays is the param times something in
// which the param does not occur: not in its value, nor in the conditions under which it is paid,
// nor in the memory that either of them reads. With twice the weight and the same motion, the term
// pays twice as much and all terms that it is not a weight of pay the same.
//
// The search is conservative: what is called a weight is one, but not every weight is found.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/check/checked_task.h"

namespace compiler {

struct ParamUse {
  std::vector<uint32_t> scales{};  // the terms that it is a weight of, in their order
  // It has a say in when episodes end: in the condition of an end or a requirement, or in what that
  // reads, as a memory that adds up the reward. Then another weight may also end an episode at
  // another time.
  bool changes_course = false;
};

struct Weights {
  std::vector<ParamUse> params;                // as in the task
  std::vector<std::optional<uint32_t>> terms;  // the weight of each; of several, the one that
                                               // scales the fewest terms, the first of those
};

Weights FindWeights(const CheckedTask& task);

}  // namespace compiler
