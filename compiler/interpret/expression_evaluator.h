// The value of an expression.
#pragma once

#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/value.h"
#include "compiler/interpret/blame.h"
#include "compiler/interpret/frame.h"
#include "compiler/interpret/random_numbers.h"

namespace compiler {

class ExpressionEvaluator {
 public:
  // Refers to its arguments, which must outlive it. `locals` are those of the event or function
  // around the expression, `arguments` those of the function; `draw` is for a goal's equation.
  ExpressionEvaluator(const CheckedTask& task, const Frame& frame, const std::vector<Value>& locals,
                      const std::vector<Value>& arguments, const DrawPlace& draw);

  Value Evaluate(const CheckedExpression& expression) const;

  // Of an expression whose value is not finite, or too large: where that comes from. `lets`: of the
  // locals.
  Blame BlameFor(const CheckedExpression& expression, const LetValues& lets) const;

 private:
  Value Of(const Constant& node, const Type& type) const;
  Value Of(const ConstRead& node, const Type& type) const;
  Value Of(const SensorRead& node, const Type& type) const;
  Value Of(const ParamRead& node, const Type& type) const;
  Value Of(const MemoryRead& node, const Type& type) const;
  Value Of(const LocalRead& node, const Type& type) const;
  Value Of(const ArgumentRead& node, const Type& type) const;
  Value Of(const RewardSoFar& node, const Type& type) const;
  Value Of(const TimeStep& node, const Type& type) const;
  Value Of(const Elements& node, const Type& type) const;
  Value Of(const CheckedUnary& node, const Type& type) const;
  Value Of(const CheckedBinary& node, const Type& type) const;
  Value Of(const CheckedWithin& node, const Type& type) const;
  Value Of(const BuiltinCall& node, const Type& type) const;
  Value Of(const FunctionCall& node, const Type& type) const;
  Blame BlameInside(const FunctionCall& call, const Type& type) const;
  Value Call(const CheckedFunction& function, const std::vector<Value>& arguments) const;
  Value Of(const Draw& node, const Type& type) const;
  Value Of(const TableRead& node, const Type& type) const;
  Value Of(const TestRead& node, const Type& type) const;
  Value Of(const IntToReal& node, const Type& type) const;

  Value Choice(const Draw& node, const Type& type, const std::vector<Value>& values) const;
  std::vector<Value> EvaluateAll(const std::vector<CheckedExpressionPtr>& expressions) const;

  const CheckedTask& task_;
  const Frame& frame_;
  const std::vector<Value>& locals_;
  const std::vector<Value>& arguments_;
  const DrawPlace draw_;
};

}  // namespace compiler
