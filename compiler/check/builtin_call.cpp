#include "compiler/check/builtin_call.h"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "compiler/check/elements.h"
#include "compiler/check/fold.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"
#include "compiler/check/unit.h"

namespace compiler {
namespace {

using enum ArgumentRule;

constexpr Unit kRadian{.radian = 1};

// One call of a function.
class BuiltinCheck {
 public:
  BuiltinCheck(const BuiltinDescription& builtin, Span span, std::vector<Operand> arguments,
               Diagnostics& diagnostics)
      : builtin_(builtin),
        span_(span),
        arguments_(std::move(arguments)),
        diagnostics_(diagnostics) {}

  std::optional<CheckedExpression> Check() {
    if (!CheckCount() || !CheckTypes()) return std::nullopt;
    const auto unit = ResultUnit();
    if (!unit) return std::nullopt;
    ConvertArguments();
    if (const auto* composite = std::get_if<Composite>(&builtin_.function))
      return Replaced(*composite, *unit);
    const auto function = std::get<Builtin>(builtin_.function);
    if (rule() == kTwoRows) MakeAlike(argument(0), argument(1));
    const bool goes_by_parts = rule() == kNumbers || rule() == kTwoVec3;
    if (goes_by_parts && HasVectors()) return Replaced(function, *unit);
    return Build(function, *unit);
  }

 private:
  CheckedExpression& argument(size_t i) { return arguments_[i].expression; }
  const Type& type(size_t i) { return arguments_[i].expression.type; }

  bool Is(std::variant<Builtin, Composite> function) const { return builtin_.function == function; }
  bool IsComposite() const { return std::holds_alternative<Composite>(builtin_.function); }
  // `min`, `max`: of one vector or array, or of several numbers.
  bool IsExtremum() const { return Is(Builtin::kMin) || Is(Builtin::kMax); }
  ArgumentRule rule() const {
    return IsExtremum() && arguments_.size() == 1 ? kNumbers : builtin_.arguments;
  }

  bool CheckCount() {
    const size_t count = arguments_.size();
    if (count >= builtin_.min_arguments && count <= builtin_.max_arguments) return true;
    const std::string wanted =
        builtin_.min_arguments == builtin_.max_arguments
            ? std::to_string(builtin_.min_arguments)
            : fmt::format("{} to {}", builtin_.min_arguments, builtin_.max_arguments);
    Report(diagnostics_, code::kWrongArgumentCount, span_,
           fmt::format("`{}` takes {} argument{}, not {}", builtin_.name, wanted,
                       wanted == "1" ? "" : "s", count),
           {.help = fmt::format("write `{}`", builtin_.usage)});
    return false;
  }

  bool CheckTypes() {
    bool fits = true;
    for (size_t i = 0; i < arguments_.size(); ++i) fits = CheckType(i) && fits;
    if (!fits) return false;
    if (rule() == kTwoRows || rule() == kTwoVec3) return AreVectorsAlike();
    if (rule() == kChoice && IsScalar(type(0))) return AreOfOneType(1, 2);
    if (rule() == kChoice)
      return IsBool(type(1)) == IsBool(type(2)) ? AreOfOneShape() : AreOfOneType(1, 2);
    if (IsOfElements() && !AreOfOneShape()) return false;
    return !Is(Composite::kTolerance) || HasMargin();
  }

  // Does it apply to each element of what it is given?
  bool IsOfElements() const { return rule() == kElements || rule() == kRealElements; }

  // The first of the arguments that is no scalar, or the first one.
  const CheckedExpression& FirstWithShape(size_t count) {
    for (size_t i = 0; i < count; ++i)
      if (!IsScalar(type(i))) return argument(i);
    return argument(0);
  }

  // But for those that are scalars, which apply to each element of the others.
  bool AreOfOneShape() {
    const CheckedExpression& first = FirstWithShape(arguments_.size());
    for (size_t i = 0; i < arguments_.size(); ++i) {
      Type shape = type(i);
      shape.scalar = first.type.scalar;
      if (IsScalar(shape) || shape == first.type) continue;
      Report(diagnostics_, code::kWrongArgument, span_,
             fmt::format("`{}` needs values of one shape, or single ones", builtin_.name),
             {.labels = {{first.span, fmt::format("`{}`", ToString(first.type))},
                         {argument(i).span, fmt::format("`{}`", ToString(type(i)))}}});
      return false;
    }
    return true;
  }

  bool HasVectors() const {
    return std::ranges::any_of(arguments_, [](const Operand& operand) {
      return compiler::HasVectors(operand.expression.type);
    });
  }

  // Of one type, or a vector beside an array of such.
  bool AreVectorsAlike() {
    const auto is_one_of = [](const Type& vector, const Type& array) {
      return compiler::HasVectors(array) && vector == EntryOf(array);
    };
    return is_one_of(type(0), type(1)) || is_one_of(type(1), type(0)) || AreOfOneType(0, 1);
  }

  // But for the difference between ints and reals.
  bool AreOfOneType(size_t i, size_t j) {
    Type first = type(i);
    if (IsNumber(first) && IsNumber(type(j))) first.scalar = type(j).scalar;
    if (first == type(j)) return true;
    Report(diagnostics_, code::kWrongArgument, span_,
           fmt::format("`{}` needs two values of the same type", builtin_.name),
           {.labels = {{argument(i).span, fmt::format("`{}`", ToString(type(i)))},
                       {argument(j).span, fmt::format("`{}`", ToString(type(j)))}}});
    return false;
  }

  bool HasMargin() {
    const auto margin = ValueOf(argument(3));
    if (!margin || *margin > 0) return true;
    Report(diagnostics_, code::kWrongArgument, argument(3).span,
           "`tolerance` needs a margin above 0",
           {.note = "this is 0 or less", .help = "without a margin, write a comparison"});
    return false;
  }

  bool CheckType(size_t i) {
    if (Accepts(i, type(i))) return true;
    Report(diagnostics_, code::kWrongArgument, argument(i).span,
           fmt::format("`{}` needs {}", builtin_.name, Wanted(i)),
           {.note = fmt::format("this is {}", WithArticle(type(i))), .help = HelpForType(type(i))});
    return false;
  }

  bool Accepts(size_t i, const Type& type) const {
    switch (rule()) {
      case kConditions:
        return IsBool(type);
      case kNumbers:
        return IsNumber(type) && (IsScalar(type) || IsRow(type)) && !IsOfQuaternions(type);
      case kRow:
      case kTwoRows:
        return IsNumber(type) && IsRow(type) && !IsOfQuaternions(type) && IsOpenTo(type);
      case kTwoVec3:
        return IsOfVec3(type) && IsOpenTo(type);
      case kChoice:
        return i > 0 || IsBool(type);
      case kRotation:
        return i > 0 ? IsOfVec3(type)
                     : type.shape == Shape::kQuaternion ||
                           (type.shape == Shape::kMatrix && type.rows == 3);
      case kQuaternion:
        return type.shape == Shape::kQuaternion;
      case kMatrix:
        return type.shape == Shape::kMatrix;
      case kElements:
      case kRealElements:
        return IsNumber(type) && !IsOfQuaternions(type);
      case kParts:
        return IsNumber(type) && IsScalar(type);
    }
    return false;
  }

  // Some equations are of a single vector.
  bool IsOpenTo(const Type& type) const {
    const bool is_of_one = Is(Composite::kNormalize) || Is(Composite::kAngleBetween);
    return !is_of_one || !compiler::HasVectors(type);
  }

  std::string_view Wanted(size_t i) const {
    switch (rule()) {
      case kConditions:
        return "a `bool` or an array of them";
      case kNumbers:
        return "a vector or an array of numbers";
      case kRow:
        return "a vector or an array of numbers";
      case kTwoRows:
        return "two vectors or arrays of numbers";
      case kTwoVec3:
        return "two `vec3`";
      case kChoice:
        return "a `bool` or an array of them first";
      case kRotation:
        return i > 0 ? "a `vec3` to rotate" : "a `quat` or a `mat3` first";
      case kQuaternion:
        return "a `quat`";
      case kMatrix:
        return "a matrix";
      case kElements:
      case kRealElements:
        return "numbers";
      case kParts:
        return "single numbers";
    }
    return "";
  }

  std::string HelpForType(const Type& type) const {
    if (rule() == kConditions) return "compare it, as in `x > 0`";
    if (IsBool(type)) return "`count` tells how many conditions are true";
    if (compiler::HasVectors(type)) return "take one of its entries, as in `v[0]`";
    if (Is(Builtin::kNorm) && IsScalar(type)) return "the magnitude of a single number is `abs(x)`";
    return "";
  }

  // ---- Units ----

  std::optional<Unit> ResultUnit() {
    switch (builtin_.units) {
      case UnitRule::kNone:
        return Unit{};
      case UnitRule::kSame:
        return CommonUnit();
      case UnitRule::kProduct:
        return ProductOfUnits();
      case UnitRule::kSquareRoot:
        return RootOfUnit();
      case UnitRule::kPlain:
        return Needs(0, {}) ? std::optional(Unit{}) : std::nullopt;
      case UnitRule::kAllPlain:
        return Needs(0, {}) && Needs(1, {}) ? std::optional(Unit{}) : std::nullopt;
      case UnitRule::kAngleToPlain:
        return Needs(0, kRadian) ? std::optional(Unit{}) : std::nullopt;
      case UnitRule::kPlainToAngle:
        return Needs(0, {}) ? std::optional(kRadian) : std::nullopt;
      case UnitRule::kAngle:
        return Needs(0, kRadian) ? std::optional(kRadian) : std::nullopt;
      case UnitRule::kSameToAngle:
        return CommonUnit() ? std::optional(kRadian) : std::nullopt;
      case UnitRule::kSameToPlain:
        return CommonUnit() ? std::optional(Unit{}) : std::nullopt;
      case UnitRule::kToPlain:
        return Unit{};
      case UnitRule::kToAngle:
        return kRadian;
      case UnitRule::kOfRotated:
        return Needs(0, {}) ? std::optional(argument(1).unit) : std::nullopt;
    }
    return std::nullopt;
  }

  std::optional<Unit> CommonUnit() {
    // The condition of a choice has no unit.
    const std::span<Operand> values = std::span(arguments_).subspan(rule() == kChoice ? 1 : 0);
    const auto with_unit = std::ranges::find_if(
        values, [](const Operand& operand) { return !IsLiteralZero(operand.syntax); });
    if (with_unit == values.end()) return Unit{};
    const Unit unit = with_unit->expression.unit;
    for (Operand& operand : values) {
      if (IsLiteralZero(operand.syntax)) operand.expression.unit = unit;
      if (operand.expression.unit == unit) continue;
      const CheckedExpression& first = with_unit->expression;
      const CheckedExpression& other = operand.expression;
      Report(diagnostics_, code::kArgumentUnits, span_,
             fmt::format("`{}` needs values of one unit, not {} and {}", builtin_.name,
                         NameOf(unit), NameOf(other.unit)),
             {.help = HelpForUnit(other.unit, operand.syntax, unit),
              .labels = {{first.span, NameOf(unit)}, {other.span, NameOf(other.unit)}}});
      return std::nullopt;
    }
    return unit;
  }

  std::optional<Unit> ProductOfUnits() {
    const auto unit = Multiply(argument(0).unit, argument(1).unit);
    if (!unit)
      Report(diagnostics_, code::kUnitTooLarge, span_, "the unit of this has a power beyond 127");
    return unit;
  }

  std::optional<Unit> RootOfUnit() {
    const auto unit = SquareRoot(argument(0).unit);
    if (!unit)
      Report(diagnostics_, code::kOddRoot, argument(0).span,
             fmt::format("{} has no square root", NameOf(argument(0).unit)),
             {.note = "the powers of its base units must be even"});
    return unit;
  }

  // The argument must have the unit `wanted`: none or that of angles.
  bool Needs(size_t i, const Unit& wanted) {
    CheckedExpression& value = argument(i);
    if (IsLiteralZero(arguments_[i].syntax)) value.unit = wanted;
    if (value.unit == wanted) return true;
    const std::string_view code = IsPlain(wanted) ? code::kNotPlain : code::kNotAnAngle;
    Help help = HelpForUnit(value.unit, arguments_[i].syntax, wanted);
    if (help.empty() && IsPlain(wanted))
      help = fmt::format("divide by a reference, as in `x / 1 {}`", ToString(value.unit));
    Report(
        diagnostics_, code, value.span,
        fmt::format("`{}` needs {}", builtin_.name,
                    IsPlain(wanted) ? "a plain number" : "an angle"),
        {.note = fmt::format("this is {}{}", IsPlain(value.unit) ? "" : "in ", NameOf(value.unit)),
         .help = std::move(help)});
    return false;
  }

  // ---- Result ----

  bool AllInts() {
    return std::ranges::all_of(arguments_, [](const Operand& operand) {
      return operand.expression.type.scalar == Scalar::kInt;
    });
  }

  void ConvertArguments() {
    const ArgumentRule applied = rule();
    if (applied == kChoice) return ConvertChoice();
    const bool keeps_ints = !IsComposite() && (applied == kNumbers || applied == kElements);
    if (applied == kConditions || (keeps_ints && AllInts())) return;
    for (Operand& operand : arguments_) operand.expression = ToReal(std::move(operand.expression));
  }

  void ConvertChoice() {
    if (type(1).scalar == type(2).scalar) return;
    for (size_t i : {1, 2}) argument(i) = ToReal(std::move(argument(i)));
  }

  // Of a call with the first `count` arguments, after their conversion.
  Type ResultType(size_t count) {
    switch (rule()) {
      case kConditions:
        return ScalarType(Is(Builtin::kCount) ? Scalar::kInt : Scalar::kBool);
      case kNumbers:
        return ScalarType(type(0).scalar);
      case kTwoVec3:
        return type(0);
      case kElements:
      case kRealElements:
        return FirstWithShape(count).type;
      case kParts:
        return *FindType(builtin_.name);
      case kChoice: {
        Type result = IsScalar(type(0)) ? type(1) : type(0);
        result.scalar = type(1).scalar;
        return result;
      }
      case kRow:
      case kTwoRows:
        if (HasVectors()) return WithEntries(type(0), kRealType);
        break;
      case kRotation:
      case kQuaternion:
      case kMatrix:
        break;
    }
    return kRealType;
  }

  std::optional<CheckedExpression> Replaced(std::variant<Builtin, Composite> function,
                                            const Unit& unit) {
    std::vector<CheckedExpression> values;
    for (Operand& operand : arguments_) values.push_back(std::move(operand.expression));
    return Expand(function, span_, unit, std::move(values), diagnostics_);
  }

  std::optional<CheckedExpression> Build(Builtin function, const Unit& unit) {
    while (IsExtremum() && arguments_.size() > 2) {
      auto inner = Call(function, unit, 2);
      if (!inner) return std::nullopt;
      arguments_.erase(arguments_.begin());
      argument(0) = std::move(*inner);
    }
    return Call(function, unit, arguments_.size());
  }

  // The call with the first `count` arguments.
  std::optional<CheckedExpression> Call(Builtin function, const Unit& unit, size_t count) {
    const Type result = ResultType(count);
    BuiltinCall call{function, {}};
    for (size_t i = 0; i < count; ++i)
      call.arguments.push_back(std::make_unique<CheckedExpression>(std::move(argument(i))));
    return Fold({span_, result, unit, std::move(call)}, diagnostics_);
  }

  const BuiltinDescription& builtin_;
  Span span_;
  std::vector<Operand> arguments_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::optional<CheckedExpression> CheckBuiltin(const BuiltinDescription& builtin, Span span,
                                              std::vector<Operand> arguments,
                                              Diagnostics& diagnostics) {
  return BuiltinCheck(builtin, span, std::move(arguments), diagnostics).Check();
}

}  // namespace compiler
