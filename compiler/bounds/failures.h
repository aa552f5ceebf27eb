// Where a task fails, and what it pays for that.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "compiler/check/checked_task.h"

namespace compiler {

struct Failure {
  uint32_t end = 0;  // index into CheckedTask::ends
  Span span;         // of the statement
  // The terms that are paid whenever this failure is reached, by a `reward` in its block or in one
  // around it; and those of them that nothing else pays.
  std::set<uint32_t> beside{};
  std::set<uint32_t> only_here{};
  // Other terms that a `reward` pays under conditions that have to do with those of the failure.
  std::set<uint32_t> related{};
};

// Every `end_episode failure`, once for all passes of a loop.
std::vector<Failure> FailuresOf(const CheckedTask& task);

}  // namespace compiler
