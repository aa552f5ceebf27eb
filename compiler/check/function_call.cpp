#include "compiler/check/function_call.h"

#include <algorithm>
#include <utility>

#include "compiler/check/names.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"
#include "compiler/check/unit.h"

namespace compiler {
namespace {

// ---- Units --------------------------------------------------------------------------------------

// What `unit` is in a call.
struct Said {
  Unit unit;
  size_t argument = 0;  // which says it
  Span span;            // of that argument
};

// The first argument of the parameters that say it; a literal 0 says nothing. Where none does, it
// is that of plain numbers.
std::optional<Said> SaidUnit(const FunctionSignature& function,
                             const std::vector<Operand>& arguments) {
  for (size_t i = 0; i < arguments.size(); ++i)
    if (IsAnyUnit(function.parameters[i].unit) && !IsLiteralZero(arguments[i].syntax))
      return Said{arguments[i].expression.unit, i, arguments[i].expression.span};
  return std::nullopt;
}

// A declared unit as this call says it. Reports and returns nothing where it is too large.
std::optional<Unit> OpenedUnit(const Unit& declared, const std::optional<Said>& said, Span span,
                               const TaskScope& scope) {
  if (declared.any == 0) return declared;
  const auto unit = WithUnit(declared, said ? said->unit : Unit{});
  if (!unit)
    Report(scope.diagnostics, code::kUnitTooLarge, span, "the unit of this has a power beyond 127");
  return unit;
}

// ---- Elements -----------------------------------------------------------------------------------

bool IsOfSingleValues(const FunctionSignature& function) {
  return IsScalar(function.result) &&
         std::ranges::all_of(function.parameters,
                             [](const Local& parameter) { return IsScalar(parameter.type); });
}

// As many values of another kind. Conditions and ints in a row are an array.
Type WithElements(const Type& shape, Scalar scalar) {
  if (shape.shape == Shape::kVector && scalar != Scalar::kReal)
    return ArrayOf(ScalarType(scalar), shape.rows);
  Type type = shape;
  type.scalar = scalar;
  return type;
}

// Vectors and matrices are of reals alone.
bool CanHold(const Type& shape, Scalar scalar) {
  return scalar == Scalar::kReal || (IsRow(shape) && !HasVectors(shape));
}

// A function of single values applies to each element of its arguments: what they have in common, a
// scalar where they are all scalars. Nothing, after a message, where their shapes differ.
std::optional<Type> SharedShape(const FunctionSignature& function,
                                const std::vector<Operand>& arguments, Span span,
                                const TaskScope& scope) {
  const CheckedExpression* first = nullptr;
  if (!IsOfSingleValues(function)) return Type{};
  for (const Operand& argument : arguments) {
    const CheckedExpression& value = argument.expression;
    const bool is_open =
        !IsOfQuaternions(value.type) && CanHold(value.type, function.result.scalar);
    if (IsScalar(value.type) || !is_open) continue;
    if (first == nullptr) first = &value;
    if (WithElements(value.type, Scalar::kReal) == WithElements(first->type, Scalar::kReal))
      continue;
    Report(scope.diagnostics, code::kWrongArgument, span,
           fmt::format("`{}` needs values of one shape, or single ones", function.name.text),
           {.labels = {{first->span, fmt::format("`{}`", ToString(first->type))},
                       {value.span, fmt::format("`{}`", ToString(value.type))}}});
    return std::nullopt;
  }
  return first == nullptr ? Type{} : first->type;
}

}  // namespace

std::optional<CheckedExpression> CheckFunctionCall(const FunctionSignature& function, Span span,
                                                   std::vector<Operand> arguments,
                                                   const TaskScope& scope) {
  if (!function.is_valid) return std::nullopt;
  const size_t wanted = function.parameters.size();
  if (arguments.size() != wanted) {
    Report(scope.diagnostics, code::kWrongArgumentCount, span,
           fmt::format("`{}` takes {} argument{}, not {}", function.name.text, wanted,
                       wanted == 1 ? "" : "s", arguments.size()),
           {.help = fmt::format("write `{}`", UsageOf(function)),
            .labels = {{function.name.span, "declared here"}}});
    return std::nullopt;
  }
  const auto unit = SaidUnit(function, arguments);
  const auto shape = SharedShape(function, arguments, span, scope);
  if (!shape) return std::nullopt;
  FunctionCall call{scope.symbols.Find(function.name.text)->index, {}, !IsScalar(*shape)};
  for (size_t i = 0; i < wanted; ++i) {
    const Local& parameter = function.parameters[i];
    std::vector<Label> labels = {{function.parameter_spans[i], "declared here"}};
    if (unit && parameter.unit.any != 0 && i != unit->argument)
      labels.push_back({unit->span, fmt::format("so `unit` is {}", NameOf(unit->unit))});
    const auto wanted_unit = OpenedUnit(parameter.unit, unit, span, scope);
    if (!wanted_unit) return std::nullopt;
    Type type = parameter.type;
    if (call.is_each && !IsScalar(arguments[i].expression.type))
      type = WithElements(*shape, type.scalar);
    auto argument = ConvertTo(std::move(arguments[i]), type, *wanted_unit,
                              fmt::format("`{}` of `{}`", parameter.name, function.name.text),
                              scope.diagnostics, labels);
    if (argument)
      call.arguments.push_back(std::make_unique<CheckedExpression>(std::move(*argument)));
  }
  if (call.arguments.size() < wanted) return std::nullopt;
  const auto result = OpenedUnit(function.unit, unit, span, scope);
  if (!result) return std::nullopt;
  const Type type = call.is_each ? WithElements(*shape, function.result.scalar) : function.result;
  return CheckedExpression{span, type, *result, std::move(call)};
}

}  // namespace compiler
