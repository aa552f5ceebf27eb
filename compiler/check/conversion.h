// Fitting a value to where it is used: from `int` to `real` (the one implicit conversion) and from
// a literal 0 to any unit; everything else is a mistake that is reported.
#pragma once

#include <optional>
#include <string>

#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// A checked expression with what was written for it; `syntax` is null for what the checker inserts.
struct Operand {
  CheckedExpression expression;
  const Expression* syntax = nullptr;
};

// Is it a 0 without a unit, as in `x > 0`? It fits every unit.
bool IsLiteralZero(const Expression* syntax);

// The same value as a real; reals stay as they are.
CheckedExpression ToReal(CheckedExpression expression);

// "`m/s`", or "a plain number".
std::string NameOf(const Unit& unit);

// How to get from a value of unit `have` to one of unit `want`; empty where nothing general can be
// said. `syntax` is what was written for the value, or null.
Help HelpForUnit(const Unit& have, const Expression* syntax, const Unit& want);

// The value as type and unit of a place that is called `place` in messages, such as "`fallen`".
// Reports, with further `labels`, and returns nothing where it does not fit.
std::optional<CheckedExpression> ConvertTo(Operand value, const Type& type, const Unit& unit,
                                           const std::string& place, Diagnostics& diagnostics,
                                           const std::vector<Label>& labels = {});

}  // namespace compiler
