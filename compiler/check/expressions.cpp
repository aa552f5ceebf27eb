#include "compiler/check/expressions.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "compiler/check/builtin_call.h"
#include "compiler/check/builtins.h"
#include "compiler/check/constant_value.h"
#include "compiler/check/conversion.h"
#include "compiler/check/draws.h"
#include "compiler/check/elements.h"
#include "compiler/check/fold.h"
#include "compiler/check/function_call.h"
#include "compiler/check/method_call.h"
#include "compiler/check/names.h"
#include "compiler/check/operators.h"
#include "compiler/check/phase_names.h"
#include "compiler/check/report.h"
#include "compiler/check/tables.h"
#include "compiler/check/test_read.h"
#include "compiler/check/time_functions.h"
#include "compiler/check/type.h"
#include "compiler/check/unit.h"
#include "compiler/check/written_form.h"

namespace compiler {
namespace {

// Goes down an expression; one function for each kind of node.
class ExpressionChecker {
 public:
  ExpressionChecker(const Place& place, const TaskScope& scope) : place_(place), scope_(scope) {}

  std::optional<CheckedExpression> Check(const Expression& expression) const {
    auto checked =
        std::visit([&](const auto& node) { return CheckNode(node, expression); }, expression.node);
    if (!checked) return checked;
    checked->span = expression.span;  // with brackets, where there are any
    return IsScalar(checked->type) ? WithoutConst(std::move(*checked)) : std::move(checked);
  }

 private:
  using Result = std::optional<CheckedExpression>;

  // An element of a const is a constant.
  CheckedExpression WithoutConst(CheckedExpression checked) const {
    const auto* elements = std::get_if<Elements>(&checked.node);
    if (elements == nullptr || !std::holds_alternative<ConstRead>(elements->operand->node))
      return checked;
    checked.node = Constant{RealOf(*ConstantValueOf(checked, scope_.constants.consts))};
    return checked;
  }

  Result CheckNode(const NumberLiteral& number, const Expression& expression) const {
    const Span span = expression.span;
    if (number.is_integer && !number.unit)
      return CheckedExpression{span, ScalarType(Scalar::kInt), {}, Constant{number.value}};
    const auto unit = CheckUnit(number.unit, scope_.diagnostics);
    if (!unit) return std::nullopt;
    const double value = unit->ToSi(number.value);
    if (std::isfinite(value))
      return CheckedExpression{span, kRealType, unit->unit, Constant{value}};
    Report(scope_.diagnostics, code::kNotFinite, span,
           fmt::format("in `{}` this is too large for a `real`", ToString(unit->unit)));
    return std::nullopt;
  }

  Result CheckNode(const BoolLiteral& literal, const Expression& expression) const {
    const double value = literal.value ? 1 : 0;
    return CheckedExpression{expression.span, ScalarType(Scalar::kBool), {}, Constant{value}};
  }

  Result CheckNode(const NameExpression& name, const Expression&) const {
    return CheckPath({name.name});
  }

  Result CheckNode(const MemberExpression&, const Expression& expression) const {
    // `base.velocity.xy` is written as members of members: the path from its root.
    std::vector<Identifier> path = PathOf(expression);
    if (!path.empty()) return CheckPath(path);
    const Expression* object = &expression;
    while (const auto* member = std::get_if<MemberExpression>(&object->node)) {
      path.push_back(member->member);
      object = member->object.get();
    }
    std::ranges::reverse(path);
    return CheckMembers(Check(*object), path, 0);
  }

  Result CheckPath(const std::vector<Identifier>& path) const {
    auto resolved = ResolvePath(path, place_, scope_);
    if (!resolved) return std::nullopt;
    return CheckMembers(std::move(resolved->expression), path, resolved->length);
  }

  Result CheckMembers(Result value, const std::vector<Identifier>& path, size_t first) const {
    for (size_t i = first; i < path.size() && value; ++i)
      value = CheckMember(std::move(*value), path[i], scope_.diagnostics);
    return value;
  }

  Result CheckNode(const IndexExpression& index, const Expression& expression) const {
    auto object = Check(*index.object);
    if (!object) return std::nullopt;
    return CheckIndex(std::move(*object), index.items, expression.span, scope_);
  }

  Result CheckNode(const CallExpression& call, const Expression& expression) const {
    if (place_.kind == Place::kExpect && IsTestFunction(call.function.text))
      return CheckTestRead(call, expression.span, place_, scope_);
    if (const Symbol* table = FindTable(call, scope_))
      return CheckTableCall(call, *table, expression.span, place_, scope_);
    if (call.function.text == kDuration && scope_.symbols.Find(kDuration) == nullptr)
      return CheckDuration(call, expression.span, scope_);
    const bool is_draw = place_.draws != nullptr && IsDrawFunction(call.function.text);
    const BuiltinDescription* builtin = FindBuiltin(call.function.text);
    const FunctionSignature* function = nullptr;
    const TimeFunctionDescription* timed = scope_.symbols.Find(call.function.text) == nullptr
                                               ? FindTimeFunction(call.function.text)
                                               : nullptr;
    if (timed != nullptr)
      return scope_.time_functions->Check(*timed, call, expression.span, place_, scope_);
    if (builtin == nullptr && !is_draw) {
      if (ReportCalledArray(call, expression.span, scope_)) return std::nullopt;
      function = ResolveFunction(call.function, place_, scope_);
    }
    std::vector<Operand> arguments;
    for (const ExpressionPtr& argument : call.arguments) {
      auto checked = Check(*argument);
      if (checked) arguments.push_back({std::move(*checked), argument.get()});
    }
    if (arguments.size() < call.arguments.size()) return std::nullopt;
    if (is_draw)
      return CheckDraw(call.function, expression.span, std::move(arguments), *place_.draws,
                       scope_.diagnostics);
    if (builtin != nullptr)
      return CheckBuiltin(*builtin, expression.span, std::move(arguments), scope_.diagnostics);
    if (function == nullptr) return std::nullopt;
    return CheckFunctionCall(*function, expression.span, std::move(arguments), scope_);
  }

  Result CheckNode(const UnaryExpression& unary, const Expression& expression) const {
    auto operand = Check(*unary.operand);
    if (!operand) return std::nullopt;
    return CheckUnaryOperator(unary.op, expression.span, std::move(*operand), scope_.diagnostics);
  }

  Result CheckNode(const BinaryExpression& binary, const Expression& expression) const {
    if (ComparesPhase(binary, scope_))
      return CheckPhaseComparison(binary, expression.span, place_, scope_);
    auto left = Check(*binary.left);
    auto right = Check(*binary.right);
    if (binary.tolerance != nullptr) {
      auto tolerance = Check(*binary.tolerance);
      if (!MayBeWithin(binary, expression.span) || !left || !right || !tolerance)
        return std::nullopt;
      return CheckWithin(binary.op, binary.op_span, {std::move(*left), binary.left.get()},
                         {std::move(*right), binary.right.get()},
                         {std::move(*tolerance), binary.tolerance.get()}, scope_.diagnostics);
    }
    if (!left || !right) return std::nullopt;
    if (binary.op == BinaryOperator::kDivide && ReportZero(*binary.right)) return std::nullopt;
    return CheckBinaryOperator(binary.op, binary.op_span, {std::move(*left), binary.left.get()},
                               {std::move(*right), binary.right.get()}, scope_.diagnostics);
  }

  // A `let` that is always 0 as the divisor.
  bool ReportZero(const Expression& divisor) const {
    const auto* name = std::get_if<NameExpression>(&divisor.node);
    const Symbol* symbol = name != nullptr ? scope_.symbols.Find(name->name.text) : nullptr;
    if (symbol == nullptr || symbol->constant != 0) return false;
    Report(scope_.diagnostics, code::kDivisionByZero, divisor.span, "the divisor is always 0",
           {.labels = {{symbol->span, "this is 0"}}});
    return true;
  }

  Result CheckNode(const MethodExpression& method, const Expression& expression) const {
    ReportMethodCall(method, expression.span, scope_);
    return std::nullopt;
  }

  Result CheckNode(const LostExpression&, const Expression&) const { return std::nullopt; }

  bool MayBeWithin(const BinaryExpression& comparison, Span span) const {
    const bool is_equality =
        comparison.op == BinaryOperator::kEqual || comparison.op == BinaryOperator::kNotEqual;
    if (!is_equality) {
      Report(scope_.diagnostics, code::kBadWithin, comparison.op_span,
             "only `==` and `!=` can be `within`",
             {.help = "leave out `within`, or add the tolerance to one side"});
    } else if (place_.kind != Place::kExpect) {
      Report(scope_.diagnostics, code::kBadWithin, span,
             "`within` is allowed only after the `expect` of a test",
             {.help = "elsewhere, compare the difference: `abs(a - b) <= 1 cm`"});
    } else {
      return true;
    }
    return false;
  }

  // The parser lets ranges and sets stand only inside an index, which CheckIndex resolves.
  Result CheckNode(const RangeExpression&, const Expression&) const { return OnlyInsideIndex(); }
  Result CheckNode(const SetExpression&, const Expression&) const { return OnlyInsideIndex(); }

  static Result OnlyInsideIndex() {
    assert(false);
    return std::nullopt;
  }

  const Place& place_;
  const TaskScope& scope_;
};

}  // namespace

std::optional<CheckedExpression> CheckExpression(const Expression& expression, const Place& place,
                                                 const TaskScope& scope) {
  return ExpressionChecker(place, scope).Check(expression);
}

std::optional<CheckedExpression> CheckCondition(const Expression& expression, const Place& place,
                                                const TaskScope& scope) {
  auto condition = CheckExpression(expression, place, scope);
  if (!condition || condition->type == ScalarType(Scalar::kBool)) return condition;
  const bool is_row = IsBool(condition->type);
  Report(scope.diagnostics, code::kNotACondition, expression.span,
         "a condition must be a single `bool`",
         {.note = fmt::format("this is {}", WithArticle(condition->type)),
          .help = is_row ? "reduce it with `any`, `all` or `none`" : "compare it, as in `x > 0`"});
  return std::nullopt;
}

std::optional<CheckedExpression> CheckRealNumber(const Expression& expression,
                                                 std::string_view owner, const Place& place,
                                                 const TaskScope& scope) {
  auto value = CheckExpression(expression, place, scope);
  if (!value) return std::nullopt;
  if (IsNumber(value->type) && IsScalar(value->type)) return ToReal(std::move(*value));
  std::string help = "take one element of it, or reduce it with `norm`, `sum` or the like";
  if (IsBool(value->type)) {
    help = IsScalar(value->type) ? "a `bool` is not a number: use `if`"
                                 : "`count` tells how many of them are true";
  }
  Report(scope.diagnostics, code::kNotANumber, expression.span,
         fmt::format("{} must be a single number", owner),
         {.note = fmt::format("this is {}", WithArticle(value->type)), .help = std::move(help)});
  return std::nullopt;
}

std::optional<ScaledUnit> CheckUnit(const std::optional<UnitExpression>& unit,
                                    Diagnostics& diagnostics) {
  std::optional<ScaledUnit> product = ScaledUnit{};
  if (!unit) return product;
  if (unit->is_lost) return std::nullopt;
  for (const UnitFactor& factor : unit->factors) {
    const auto named =
        factor.name.text == kAnyUnit ? ScaledUnit{{.any = 1}} : FindUnit(factor.name.text);
    assert(named);  // the names of units are words of the grammar
    product = Multiply(*product, *named, factor.power);
    if (product) continue;
    Report(diagnostics, code::kUnitTooLarge, unit->span, "the power of a unit is too large",
           {.note = "powers range from -128 to 127"});
    return std::nullopt;
  }
  return product;
}

}  // namespace compiler
