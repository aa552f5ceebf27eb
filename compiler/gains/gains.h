// Which params are the gains of which reward terms: what a task's rewards can be weighed anew by,
// without running the robot again.
//
// A param is the gain of a term if all that the term ever pays is the param times something in
// which the param does not occur: not in its value, nor in the conditions under which it is paid,
// nor in the memory that either of them reads. With twice the gain and the same motion, the term
// pays twice as much and all terms that it is no gain of pay the same.
//
// It is looked for on the safe side: what is called a gain is one, but not every gain is found.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/check/checked_task.h"

namespace compiler {

struct ParamUse {
  std::vector<uint32_t> scales{};  // the terms that it is a gain of, in their order
  // It has a say in when episodes end: in the condition of an end or a requirement, or in what that
  // reads, as a memory that adds up the reward. Then another gain may also end an episode at
  // another time.
  bool changes_course = false;
};

struct Gains {
  std::vector<ParamUse> params;                // as in the task
  std::vector<std::optional<uint32_t>> terms;  // the gain of each; of several, the one that scales
                                               // the fewest terms, the first of those
};

Gains FindGains(const CheckedTask& task);

}  // namespace compiler
