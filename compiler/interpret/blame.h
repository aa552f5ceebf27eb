// Which part of an expression its value comes from that is not finite, or too large to be paid.
#pragma once

#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/value.h"

namespace compiler {

struct BlamedOperand {
  const CheckedExpression* expression = nullptr;
  Value value;
};

// The part with a wrong value all operands of which are right; or what is only read, where that is
// wrong already.
struct Blame {
  const CheckedExpression* expression = nullptr;
  Value value;
  std::vector<BlamedOperand> operands;  // but constants
};

// Of the locals of an event or a function, by their numbers: what each was last set to; null where
// it was not.
using LetValues = std::vector<const CheckedExpression*>;

}  // namespace compiler
