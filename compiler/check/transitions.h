// The automaton that the phases of a task are.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/check/checked_task.h"

namespace compiler {

// One way from a phase to the next. Everything points into the task.
struct Transition {
  struct Condition {
    const CheckedExpression* expression = nullptr;
    bool holds = true;  // false: of an `if` whose `else` leads here
  };
  uint32_t from = 0;
  uint32_t to = 0;
  Span span{};            // of its `next`, or of the limit
  bool is_limit = false;  // the time for which the phase may last is over; it has no conditions
  std::vector<Condition> conditions{};           // from the outside in
  std::vector<const CheckedReward*> payments{};  // at once, by what runs whenever it is taken
};

// In the order of the text; a `next` in a loop counts once.
std::vector<Transition> TransitionsOf(const CheckedTask& task);

// The blocks of the phases; null where there are none.
const CheckedPhaseSwitch* FindPhaseSwitch(const CheckedTask& task);

}  // namespace compiler
