#include "compiler/bounds/domains.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/variant/overloaded.h"
#include "compiler/bounds/bounds_text.h"
#include "compiler/bounds/expression_bounds.h"
#include "compiler/bounds/narrowing.h"
#include "compiler/check/report.h"
#include "compiler/check/traversal.h"

namespace compiler {
namespace {

// Functions may call functions, each twice or more: what takes longer than this is not looked into.
constexpr int kMostSearched = 50;

// Where a function of one number has values; nothing where it has them everywhere.
std::optional<Interval> DomainOf(Builtin function) {
  if (function == Builtin::kSqrt || function == Builtin::kLog) return Interval{0, kInfinity};
  if (function == Builtin::kAsin || function == Builtin::kAcos) return Interval{-1, 1};
  return std::nullopt;
}

// Is there such a function in it, or perhaps in what it calls?
bool HasCandidate(const CheckedExpression& expression) {
  bool has_candidate = false;
  ForEachPart(expression, [&](const CheckedExpression& part) {
    const auto* call = std::get_if<BuiltinCall>(&part.node);
    has_candidate |= std::holds_alternative<FunctionCall>(part.node) ||
                     (call != nullptr && DomainOf(call->function));
  });
  return has_candidate;
}

// The logarithm of 0 is none.
bool IsBelow(const Interval& domain, Builtin function, double low) {
  return function == Builtin::kLog ? low <= domain.low : low < domain.low;
}

class DomainSearch {
 public:
  DomainSearch(const CheckedTask& task, std::vector<LeftDomain>& left) : task_(task), left_(left) {}

  void Search(const CheckedExpression& expression, const Values& values,
              const std::vector<const CheckedExpression*>& definitions) {
    const auto search = [&](const CheckedExpressionPtr& part) {
      Search(*part, values, definitions);
    };
    const auto search_if = [&](const CheckedExpressionPtr& condition, bool truth,
                               const CheckedExpressionPtr& part) {
      if (!HasCandidate(*part)) return;
      Values inside = values;
      if (Narrowing(task_, definitions, inside).Assume(*condition, truth))
        Search(*part, inside, definitions);
    };
    std::visit(variant::Overloaded{
                   [&](const CheckedBinary& node) {
                     search(node.left);
                     const bool decides =
                         node.op == BinaryOperator::kAnd || node.op == BinaryOperator::kOr;
                     if (!decides) return search(node.right);
                     search_if(node.left, node.op == BinaryOperator::kAnd, node.right);
                   },
                   [&](const BuiltinCall& node) {
                     Look(node, values);
                     if (node.function != Builtin::kSelect) {
                       std::ranges::for_each(node.arguments, search);
                     } else {
                       search(node.arguments[0]);
                       search_if(node.arguments[0], true, node.arguments[1]);
                       search_if(node.arguments[0], false, node.arguments[2]);
                     }
                   },
                   [&](const FunctionCall& node) {
                     std::ranges::for_each(node.arguments, search);
                     SearchInside(node, values);
                   },
                   [&]<typename Node>(const Node& node) {
                     if constexpr (requires { node.operand; }) search(node.operand);
                   },
               },
               expression.node);
  }

 private:
  void Look(const BuiltinCall& call, const Values& values) {
    const auto domain = DomainOf(call.function);
    if (!domain) return;
    const CheckedExpression& argument = *call.arguments[0];
    const Interval value = ExpressionBounds(task_, values).Of(argument);
    const bool is_below = value.low > -kInfinity && IsBelow(*domain, call.function, value.low);
    const bool is_above = value.high < kInfinity && value.high > domain->high;
    if (!HasNumber(value) || !(is_below || is_above)) return;
    const auto known = std::ranges::find(left_, argument.span, &LeftDomain::argument);
    if (known != left_.end()) {
      known->value = Join(known->value, value);
    } else {
      left_.push_back({call.function, argument.span, value, argument.unit});
    }
  }

  void SearchInside(const FunctionCall& call, const Values& values) {
    if (++calls_ > kMostSearched) return;
    const CheckedFunction& function = task_.functions[call.function];
    Values inside;
    for (const CheckedExpressionPtr& argument : call.arguments) {
      const Box box = ExpressionBounds(task_, values).AllOf(*argument);
      inside.arguments.push_back(call.is_each ? Box(Hull(box)) : box);
    }
    inside.locals.resize(function.locals.size());
    std::vector<const CheckedExpression*> definitions(function.locals.size());
    for (const CheckedLet& let : function.lets) {
      Search(let.value, inside, definitions);
      inside.locals[let.local] = ExpressionBounds(task_, inside).AllOf(let.value);
      definitions[let.local] = &let.value;
    }
    Search(function.value, inside, definitions);
  }

  const CheckedTask& task_;
  std::vector<LeftDomain>& left_;
  int calls_ = 0;  // of functions, looked into so far
};

struct Words {
  std::string_view name;
  std::string_view problem;
  std::string_view help;
};

Words WordsFor(const LeftDomain& left) {
  constexpr std::string_view kBeyond = "lie outside of -1 to 1";
  constexpr std::string_view kClamp = "limit it: `clamp(x, -1, 1)`; or use `angle_between`";
  const std::string_view below = left.value.low < 0 ? "be negative" : "be 0";
  if (left.function == Builtin::kSqrt) return {"sqrt", below, "limit it: `max(x, 0)`"};
  if (left.function == Builtin::kLog) return {"log", below, "limit it: `max(x, 1e-6)`"};
  return {left.function == Builtin::kAsin ? "asin" : "acos", kBeyond, kClamp};
}

}  // namespace

void WarnOfLeftDomains(const TaskBounds& bounds, Diagnostics& diagnostics) {
  for (const LeftDomain& left : bounds.left_domains) {
    const auto [name, problem, help] = WordsFor(left);
    Report(diagnostics, code::kLeftDomain, left.argument,
           fmt::format("the argument of `{}` can {}", name, problem),
           {.note = RangeText(left.value, left.unit), .help = std::string(help)});
  }
}

void FindLeftDomains(const CheckedTask& task, const Values& values,
                     const std::vector<const CheckedExpression*>& definitions,
                     const CheckedExpression& expression, std::vector<LeftDomain>& left) {
  if (HasCandidate(expression)) DomainSearch(task, left).Search(expression, values, definitions);
}

}  // namespace compiler
