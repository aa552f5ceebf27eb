// What a test expects, and why it is not so.
#pragma once

#include <string>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/interpret/evaluator.h"
#include "compiler/source/sources.h"

namespace compiler {

// A part of an expectation and what it was: `total(fall)`, "-4".
struct SeenValue {
  Span span;
  std::string value;
  std::string name{};  // where it is no part of what was written: "the difference"
};

// The values that tell why `condition`, a false one, is false: both sides of a comparison, and
// with `within` their difference; of an `and`, those of the sides that are false. Numbers that
// stand there tell nothing; consts are in `sources` by their names. Of a phase it is the name.
std::vector<SeenValue> Explain(const CheckedExpression& condition, const CheckedTask& task,
                               const Evaluator& evaluator, const Sources& sources);

}  // namespace compiler
