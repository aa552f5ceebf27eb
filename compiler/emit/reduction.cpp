#include "compiler/emit/reduction.h"

#include <fmt/format.h>

namespace compiler {

bool IsReduction(const BuiltinCall& call) {
  switch (call.function) {
    case Builtin::kAny:
    case Builtin::kAll:
    case Builtin::kNone:
    case Builtin::kCount:
    case Builtin::kSum:
    case Builtin::kNorm:
    case Builtin::kDot:
      return true;
    case Builtin::kMin:
    case Builtin::kMax:
      return call.arguments.size() == 1;
    default:
      return false;
  }
}

CppText ReductionTerm(Builtin function, const std::vector<CppText>& elements) {
  const CppText& element = elements.front();
  switch (function) {
    case Builtin::kCount:
      return {fmt::format("(long long){}", AtLeast(Precedence::kPrefix, element)),
              Precedence::kPrefix};
    case Builtin::kNorm:
      return BinaryText(BinaryOperator::kMultiply, element, element);
    case Builtin::kDot:
      return BinaryText(BinaryOperator::kMultiply, element, elements[1]);
    default:
      return element;
  }
}

CppText Combine(Builtin function, Scalar scalar, const CppText& so_far, const CppText& term,
                HelperSet& helpers) {
  auto call = [&](Helper real, Helper integer) {
    std::string_view name = helpers.Use(scalar == Scalar::kInt ? integer : real);
    return CppText{fmt::format("{}({}, {})", name, so_far.text, term.text)};
  };
  switch (function) {
    case Builtin::kAny:
    case Builtin::kNone:
      return BinaryText(BinaryOperator::kOr, so_far, term);
    case Builtin::kAll:
      return BinaryText(BinaryOperator::kAnd, so_far, term);
    case Builtin::kMin:
      return call(Helper::kMin, Helper::kMinInt);
    case Builtin::kMax:
      return call(Helper::kMax, Helper::kMaxInt);
    default:
      return BinaryText(BinaryOperator::kAdd, so_far, term);
  }
}

CppText FinishReduction(Builtin function, const CppText& joined) {
  switch (function) {
    case Builtin::kNone:
      return {fmt::format("!{}", AtLeast(Precedence::kPrimary, joined)), Precedence::kPrefix};
    case Builtin::kNorm:
      return {fmt::format("__builtin_sqrt({})", joined.text)};
    default:
      return joined;
  }
}

}  // namespace compiler
