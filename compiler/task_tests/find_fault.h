// A reward that a run did not pay, since it was not finite or too large, computed again.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/source/sources.h"

namespace compiler {

// What the task worked on before the event in which that happened. Lists are indexed like those of
// the task; ints and bools are exact numbers.
struct FaultySituation {
  EventKind event = EventKind::kEndOfTimeStep;
  uint32_t term = 0;
  double time_step = 0;
  uint64_t seed = 0;  // decides what is drawn
  double discount = 1;
  EndKind outcome = EndKind::kTruncated;
  std::vector<double> params;
  std::vector<std::vector<double>> sensors;
  std::vector<std::vector<double>> memory;
};

// Part of an expression, as the task writes it, and its value as a person reads it.
struct ValueOfPart {
  Span span;
  std::string value;
};

struct FoundFault {
  ValueOfPart part;                   // where it comes from
  std::vector<ValueOfPart> operands;  // what that is computed from
};

// Nothing where the term is paid in this situation. Throws CallError for a situation of another
// task.
std::optional<FoundFault> FindFault(const CheckedTask& task, const FaultySituation& situation);

}  // namespace compiler
