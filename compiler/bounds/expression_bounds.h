// The bounds of an expression's value.
#pragma once

#include "compiler/bounds/values.h"
#include "compiler/check/checked_task.h"

namespace compiler {

class ExpressionBounds {
 public:
  // Both must outlive this.
  ExpressionBounds(const CheckedTask& task, const Values& values)
      : ExpressionBounds(task, values, own_calls_, 0) {}
  ExpressionBounds(const ExpressionBounds&) = delete;
  ExpressionBounds& operator=(const ExpressionBounds&) = delete;

  // Of a scalar.
  Interval Of(const CheckedExpression& expression);
  // Of each element of any value.
  Box AllOf(const CheckedExpression& expression);

 private:
  // `calls`: how many calls of functions were looked into so far, to know when to stop.
  ExpressionBounds(const CheckedTask& task, const Values& values, int& calls, int depth)
      : task_(task), values_(values), calls_(calls), depth_(depth) {}

  Box Calculate(const CheckedBinary& binary);
  Box Calculate(const Elements& elements);
  Box Calculate(const BuiltinCall& call, const Type& type);
  Box Calculate(const Draw& draw, const Type& type);
  Box Calculate(const TableRead& read);
  Box Calculate(const FunctionCall& call, const Type& type);
  Box Call(const FunctionCall& call, std::vector<Box> arguments, Scalar result);

  const CheckedTask& task_;
  const Values& values_;
  int own_calls_ = 0;
  int& calls_;
  int depth_;
};

// What a goal can become when it is drawn: the bounds of each of its elements.
Box GoalBounds(const CheckedTask& task, const Values& values, const CheckedGoal& goal);

// What a function of the past can give, whose argument has these bounds.
// `time_step`: the length of every step [s], or infinite where no robot says.
Box TimeFunctionBounds(TimeFunction function, const Box& argument, Scalar scalar, double time_step);

// Are these reads of the same value?
bool IsSameRead(const CheckedExpression& a, const CheckedExpression& b);

}  // namespace compiler
