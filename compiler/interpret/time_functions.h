// What the functions of the past become in a time step.
#pragma once

#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/value.h"

namespace compiler {

struct TimeStepOf {
  const CheckedTimeFunction& function;
  bool is_start = false;      // of an episode
  bool counts_steps = false;  // `duration`, of a delay
  double duration = 0;        // [s], or time steps; 0 where the function has none
  double time_step = 0;       // [s]
};

// Brings what the function gives, and what it remembers, up to date. `now`: its argument.
void Advance(const TimeStepOf& step, const Value& now, std::vector<Value>& memory);

}  // namespace compiler
