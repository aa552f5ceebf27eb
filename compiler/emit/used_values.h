// What the code of one function refers to, so that it names nothing else at its start.
#pragma once

#include <set>

#include "compiler/check/checked_task.h"

namespace compiler {

struct UsedValues {
  std::set<uint32_t> sensors;
  std::set<uint32_t> params;
  bool memory = false;
  bool reward = false;  // pays a term or reads the sum so far

  void Add(const CheckedExpression& expression);
  void Add(const CheckedBlock& block);
};

// Whether the value depends on the memory variable.
bool Reads(const CheckedExpression& expression, uint32_t memory);

}  // namespace compiler
