// What a condition says about the values it looks at.
#pragma once

#include <vector>

#include "compiler/bounds/values.h"
#include "compiler/check/checked_task.h"

namespace compiler {

class Narrowing {
 public:
  // Narrows `values`. `definitions`: for each local what it was computed from, or null where that
  // may have changed since. All must outlive this.
  Narrowing(const CheckedTask& task, const std::vector<const CheckedExpression*>& definitions,
            Values& values)
      : task_(task), definitions_(definitions), values_(values) {}

  // Takes `condition` for true, or for false. Returns whether that can be; if not, the values are
  // of no more use.
  bool Assume(const CheckedExpression& condition, bool truth);

 private:
  bool Assume(const CheckedUnary& unary, bool truth);
  bool Assume(const CheckedBinary& binary, bool truth);
  bool Assume(const BuiltinCall& call, bool truth);
  // Of one element of the operands.
  bool AssumeComparison(const CheckedBinary& comparison, uint32_t element, bool truth);
  // One of the two holds, or both.
  bool AssumeEither(const CheckedExpression& a, const CheckedExpression& b, bool truth);
  bool AssumeEach(const CheckedExpression& conditions, bool truth);
  bool AssumeSome(const CheckedExpression& conditions, bool truth);
  // Of several conditions one.
  bool AssumeElement(const CheckedExpression& conditions, uint32_t element, bool truth);

  // The number `expression` lies in `range`.
  bool Restrict(const CheckedExpression& expression, const Interval& range);
  bool Restrict(const CheckedBinary& binary, Scalar scalar, const Interval& range);
  bool Restrict(const BuiltinCall& call, const Interval& range);
  // A scalar has one value for all elements.
  bool RestrictElement(const CheckedExpression& expression, uint32_t element,
                       const Interval& range);

  Interval Of(const CheckedExpression& expression) const;
  Interval Of(const CheckedExpression& expression, uint32_t element) const;
  // Where the value of a mere read is kept; null for all else.
  Box* BoxOf(const CheckedExpression& expression);

  const CheckedTask& task_;
  const std::vector<const CheckedExpression*>& definitions_;
  Values& values_;
  int cases_ = 0;  // how deep we are in cases of `or`
};

}  // namespace compiler
