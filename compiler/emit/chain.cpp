#include "compiler/emit/chain.h"

#include <fmt/format.h>

#include <cstdlib>

#include "compiler/check/type.h"

namespace compiler {

std::optional<Chain> ChainOf(const BuiltinCall& call) {
  const Emission emission = EmissionOf(call.function);
  const auto* chain = std::get_if<Chain>(&emission);
  if (chain == nullptr) return std::nullopt;
  if (chain->joins_arguments && call.arguments.size() > 1) return std::nullopt;
  return *chain;
}

bool IsOfEachVector(const BuiltinCall& call, const Chain& chain) {
  const bool takes_vectors =
      chain.term == Chain::Term::kSquare || chain.term == Chain::Term::kProduct;
  return takes_vectors && HasVectors(call.arguments.front()->type);
}

CppText ChainTerm(Chain::Term term, const std::vector<CppText>& elements) {
  const CppText& element = elements.front();
  switch (term) {
    case Chain::Term::kElement:
      return element;
    case Chain::Term::kCount:
      return {fmt::format("(long long){}", AtLeast(Precedence::kPrefix, element)),
              Precedence::kPrefix};
    case Chain::Term::kSquare:
      return BinaryText(BinaryOperator::kMultiply, element, element);
    case Chain::Term::kProduct:
      return BinaryText(BinaryOperator::kMultiply, element, elements[1]);
  }
  std::abort();
}

CppText Combine(Chain::Join join, Scalar scalar, const CppText& so_far, const CppText& term,
                HelperSet& helpers) {
  auto call = [&](Helper real, Helper integer) {
    std::string_view name = helpers.Use(scalar == Scalar::kInt ? integer : real);
    return CppText{fmt::format("{}({}, {})", name, so_far.text, term.text)};
  };
  switch (join) {
    case Chain::Join::kOr:
      return BinaryText(BinaryOperator::kOr, so_far, term);
    case Chain::Join::kAnd:
      return BinaryText(BinaryOperator::kAnd, so_far, term);
    case Chain::Join::kSum:
      return BinaryText(BinaryOperator::kAdd, so_far, term);
    case Chain::Join::kMin:
      return call(Helper::kMin, Helper::kMinInt);
    case Chain::Join::kMax:
      return call(Helper::kMax, Helper::kMaxInt);
  }
  std::abort();
}

CppText FinishChain(Chain::Finish finish, const CppText& joined) {
  switch (finish) {
    case Chain::Finish::kNothing:
      return joined;
    case Chain::Finish::kNot:
      return {fmt::format("!{}", AtLeast(Precedence::kPrimary, joined)), Precedence::kPrefix};
    case Chain::Finish::kSquareRoot:
      return {fmt::format("__builtin_sqrt({})", joined.text)};
  }
  std::abort();
}

}  // namespace compiler
