// What a test expects, and why it is not so.
#pragma once

#include <string>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/interpret/evaluator.h"

namespace compiler {

// A part of an expectation and what it was: `total(fall)`, "-4".
struct SeenValue {
  Span span;
  std::string value;
};

// The values that tell why `condition`, a false one, is false: both sides of a comparison; of an
// `and`, those of the sides that are false. Constants tell nothing.
std::vector<SeenValue> Explain(const CheckedExpression& condition, const Evaluator& evaluator);

}  // namespace compiler
