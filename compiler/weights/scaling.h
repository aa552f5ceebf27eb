// How the value of an expression follows one param while all that is sensed stays the same.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "compiler/check/checked_task.h"

namespace compiler {

enum class Scaling {
  kZero,          // it is 0, and so both of the next two
  kIndependent,   // the param does not occur in it
  kProportional,  // it is the param times something in which the param does not occur
  kOther          // or it is not known to be any of these
};

inline bool IsIndependent(Scaling scaling) { return scaling <= Scaling::kIndependent; }

// Of a sum, and of what is now the one, now the other.
Scaling Sum(Scaling left, Scaling right);

// Where the values that an expression reads come from.
struct ScalingOfReads {
  std::vector<Scaling> memory{};                  // for each memory
  std::vector<Scaling> locals{};                  // of the event or function
  std::vector<Scaling> arguments{};               // of the function
  Scaling reward_so_far = Scaling::kIndependent;  // of the callback
};

// In one param. All elements of a value with a shape count together.
class ExpressionScaling {
 public:
  // The task must outlive this.
  ExpressionScaling(const CheckedTask& task, uint32_t param) : task_(task), param_(param) {}

  Scaling Of(const CheckedExpression& expression, const ScalingOfReads& reads);

 private:
  Scaling OfBinary(const CheckedBinary& binary, const ScalingOfReads& reads);
  Scaling OfBuiltin(const BuiltinCall& call, const ScalingOfReads& reads);
  Scaling OfFunction(const FunctionCall& call, const ScalingOfReads& reads);
  Scaling OfResult(const CheckedFunction& function, const std::vector<Scaling>& arguments);
  std::vector<Scaling> OfAll(const std::vector<CheckedExpressionPtr>& expressions,
                             const ScalingOfReads& reads);

  const CheckedTask& task_;
  uint32_t param_;
  // Of each function, for the arguments that it was called with: calls inside of calls can be very
  // many.
  std::map<std::pair<uint32_t, std::vector<Scaling>>, Scaling> results_{};
};

}  // namespace compiler
