#include "compiler/check/operators.h"

#include <string_view>
#include <utility>

#include "compiler/check/composites.h"
#include "compiler/check/elements.h"
#include "compiler/check/fold.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"
#include "compiler/check/unit.h"
#include "compiler/check/written_form.h"
#include "compiler/syntax/words.h"

namespace compiler {
namespace {

bool IsArithmetic(BinaryOperator op) { return op <= BinaryOperator::kDivide; }
bool IsLogic(BinaryOperator op) { return op >= BinaryOperator::kAnd; }
bool IsSum(BinaryOperator op) {
  return op == BinaryOperator::kAdd || op == BinaryOperator::kSubtract;
}
bool IsEquality(BinaryOperator op) {
  return op == BinaryOperator::kEqual || op == BinaryOperator::kNotEqual;
}

// One application of a binary operator.
class BinaryCheck {
 public:
  BinaryCheck(BinaryOperator op, Span op_span, Operand left, Operand right,
              Diagnostics& diagnostics)
      : op_(op),
        op_span_(op_span),
        left_(std::move(left)),
        right_(std::move(right)),
        diagnostics_(diagnostics) {}

  std::optional<CheckedExpression> Check() {
    if (IsLogic(op_)) return CheckLogic();
    return IsArithmetic(op_) ? CheckArithmetic() : CheckComparison();
  }

  std::optional<CheckedExpression> CheckWithin(Operand tolerance) {
    if (!CanCompare()) return std::nullopt;
    if (IsBool(left().type)) return WrongOperands("`within` compares numbers");
    if (!IsScalar(left().type) || !IsScalar(right().type))
      return WrongOperands(
          "`within` compares single numbers: one element, or the `norm` of the difference");
    const Unit unit = left().unit;
    const bool is_negative = ValueOf(tolerance.expression).value_or(0) < 0;
    const Span span = Cover(left().span, tolerance.expression.span);
    auto within = ConvertTo(std::move(tolerance), kRealType, unit, "`within`", diagnostics_);
    if (!within) return std::nullopt;
    if (is_negative) {
      Report(diagnostics_, code::kBadWithin, within->span, "a difference is never negative");
      return std::nullopt;
    }
    CheckedWithin node{std::make_unique<CheckedExpression>(ToReal(std::move(left()))),
                       std::make_unique<CheckedExpression>(ToReal(std::move(right()))),
                       std::make_unique<CheckedExpression>(std::move(*within)),
                       op_ == BinaryOperator::kEqual};
    return CheckedExpression{span, ScalarType(Scalar::kBool), {}, std::move(node)};
  }

 private:
  CheckedExpression& left() { return left_.expression; }
  CheckedExpression& right() { return right_.expression; }

  std::optional<CheckedExpression> CheckLogic() {
    const bool left_fits = IsCondition(left());  // both are checked, for their messages
    const bool fits = IsCondition(right()) && left_fits;
    return fits ? BuildConditions() : std::nullopt;
  }

  bool IsCondition(const CheckedExpression& operand) {
    if (IsBool(operand.type)) return true;
    Report(diagnostics_, code::kWrongOperand, operand.span,
           fmt::format("`{}` joins two `bool` values", NameOf(op_, kBinarySymbols)),
           {.note = fmt::format("this is {}", WithArticle(operand.type)),
            .help = "compare it, as in `x > 0`"});
    return false;
  }

  // A condition, or one for each element.
  std::optional<CheckedExpression> BuildConditions() {
    const Type& shaped = IsScalar(left().type) ? right().type : left().type;
    Type other = right().type;
    other.scalar = shaped.scalar;
    if (!IsScalar(other) && other != shaped)
      return WrongOperands("both need the same shape, or one a single value");
    if (IsScalar(shaped)) return Build(ScalarType(Scalar::kBool), {});
    return Build(ArrayOf(ScalarType(Scalar::kBool), shaped.rows, shaped.index), {});
  }

  std::optional<CheckedExpression> CheckComparison() {
    if (!CanCompare()) return std::nullopt;
    UnifyScalars(false);
    return BuildConditions();
  }

  // A single value, or a row of such.
  static bool IsComparable(const Type& type) {
    return IsScalar(type) || (IsRow(type) && !HasVectors(type));
  }

  bool CanCompare() {
    std::string help;
    if (!IsComparable(left().type) || !IsComparable(right().type)) {
      help = "compare one element, or reduce with `norm`, `max`, `any` or the like";
    } else if (IsBool(left().type) == IsBool(right().type)) {
      if (IsNumber(left().type)) return UnifyUnits();
      if (IsEquality(op_)) return true;
      help = "only `==` and `!=` compare `bool` values";
    }
    WrongOperands(std::move(help));
    return false;
  }

  std::optional<CheckedExpression> CheckArithmetic() {
    const bool are_quaternions =
        left().type.shape == Shape::kQuaternion && right().type.shape == Shape::kQuaternion;
    if (are_quaternions && op_ == BinaryOperator::kMultiply) return CheckProduct();
    const auto type = ArithmeticType();
    if (!type) return std::nullopt;
    const auto unit = ArithmeticUnit();
    if (!unit) return std::nullopt;
    UnifyScalars(op_ == BinaryOperator::kDivide);
    MakeAlike(left(), right());
    Type result = *type;
    result.scalar = left().type.scalar;
    return Build(result, *unit);
  }

  // Of two quaternions.
  std::optional<CheckedExpression> CheckProduct() {
    const auto unit = ArithmeticUnit();
    if (!unit) return std::nullopt;
    const Span span = Cover(left().span, right().span);
    return ExpandProduct(std::move(left()), std::move(right()), span, *unit, diagnostics_);
  }

  std::optional<Type> ArithmeticType() {
    const Type& left_type = left().type;
    const Type& right_type = right().type;
    if (IsBool(left_type) || IsBool(right_type))
      return WrongOperands("a `bool` is not a number: use `if`, or `count` for how many are true");
    if (IsRotation()) return WrongOperands(RotationHelp());
    if (IsOfQuaternions(left_type) || IsOfQuaternions(right_type))
      return WrongOperands("take elements of it: `q.w`, `q.xyz`");
    if (IsScalar(right_type)) return left_type;
    if (IsScalar(left_type) && !(Has(Shape::kMatrix) && op_ == BinaryOperator::kDivide))
      return right_type;
    if (Has(Shape::kMatrix) && !IsSum(op_))
      return WrongOperands("take rows or elements of it: `dot(m[0, 0..2], v)`");
    if (AppliesToEntries(right_type, left_type)) return left_type;
    if (AppliesToEntries(left_type, right_type)) return right_type;
    Type left_shape = left_type;
    left_shape.scalar = right_type.scalar;
    if (left_shape != right_type) return WrongOperands(HelpForShapes());
    return left_type;
  }

  std::string HelpForShapes() {
    std::string help = "both need the same shape, or one a scalar";
    for (const Type& type : {left().type, right().type})
      if (HasVectors(type)) return fmt::format("{} or a `{}`", help, ToString(EntryOf(type)));
    return help;
  }

  // A vector applies to each vector of an array; a factor or divisor for each of them to its own.
  bool AppliesToEntries(const Type& operand, const Type& array) const {
    if (!HasVectors(array)) return false;
    const Type number = ScalarType(operand.scalar);
    return operand == EntryOf(array) || (!IsSum(op_) && operand == WithEntries(array, number));
  }

  // A rotation times a vector, as mathematics writes it.
  bool IsRotation() {
    const Type& rotation = left().type;
    const bool turns = rotation.shape == Shape::kQuaternion ||
                       (rotation.shape == Shape::kMatrix && rotation.rows == 3);
    return op_ == BinaryOperator::kMultiply && turns && right().type.shape == Shape::kVector &&
           right().type.rows == 3;
  }

  Help RotationHelp() {
    const auto rotation = left_.syntax != nullptr ? WrittenForm(*left_.syntax) : std::nullopt;
    const auto vector = right_.syntax != nullptr ? WrittenForm(*right_.syntax) : std::nullopt;
    if (!rotation || !vector) return "a vector is rotated by `rotate(rotation, v)`";
    const std::string call = fmt::format("rotate({}, {})", *rotation, *vector);
    return {fmt::format("a vector is rotated by `{}`", call),
            {{Cover(left().span, right().span), call}}};
  }

  std::optional<Unit> ArithmeticUnit() {
    if (IsSum(op_)) return UnifyUnits() ? std::optional(left().unit) : std::nullopt;
    const auto unit = op_ == BinaryOperator::kMultiply ? Multiply(left().unit, right().unit)
                                                       : Divide(left().unit, right().unit);
    if (!unit)
      Report(diagnostics_, code::kUnitTooLarge, Cover(left().span, right().span),
             "the unit of this has a power beyond 127");
    return unit;
  }

  bool Has(Shape shape) { return left().type.shape == shape || right().type.shape == shape; }

  // Gives both the same unit, or reports that they have different ones.
  bool UnifyUnits() {
    if (IsLiteralZero(left_.syntax)) left().unit = right().unit;
    if (IsLiteralZero(right_.syntax)) right().unit = left().unit;
    if (left().unit == right().unit) return true;
    const std::string left_name = NameOf(left().unit);
    const std::string right_name = NameOf(right().unit);
    std::string message;
    if (op_ == BinaryOperator::kAdd) {
      message = fmt::format("cannot add {} and {}", left_name, right_name);
    } else if (op_ == BinaryOperator::kSubtract) {
      message = fmt::format("cannot subtract {} from {}", right_name, left_name);
    } else {
      message = fmt::format("cannot compare {} with {}", left_name, right_name);
    }
    Report(diagnostics_, code::kUnitMismatch, op_span_, std::move(message),
           {.help = UnitHelp(), .labels = {{left().span, left_name}, {right().span, right_name}}});
    return false;
  }

  Help UnitHelp() {
    Help help = HelpForUnit(right().unit, right_.syntax, left().unit);
    return help.empty() ? HelpForUnit(left().unit, left_.syntax, right().unit) : help;
  }

  // Makes reals of both where one of them is, or where `force` says so.
  void UnifyScalars(bool force) {
    const bool has_real =
        left().type.scalar == Scalar::kReal || right().type.scalar == Scalar::kReal;
    if (!force && !has_real) return;
    left() = ToReal(std::move(left()));
    right() = ToReal(std::move(right()));
  }

  std::nullopt_t WrongOperands(Help help) {
    const std::string left_name = fmt::format("`{}`", ToString(left().type));
    const std::string right_name = fmt::format("`{}`", ToString(right().type));
    Report(diagnostics_, code::kWrongOperand, op_span_,
           fmt::format("`{}` cannot be applied to {} and {}", NameOf(op_, kBinarySymbols),
                       left_name, right_name),
           {.help = std::move(help),
            .labels = {{left().span, left_name}, {right().span, right_name}}});
    return std::nullopt;
  }

  std::optional<CheckedExpression> Build(const Type& type, const Unit& unit) {
    const Span span = Cover(left().span, right().span);
    CheckedBinary node{op_, std::make_unique<CheckedExpression>(std::move(left())),
                       std::make_unique<CheckedExpression>(std::move(right()))};
    return Fold({span, type, unit, std::move(node)}, diagnostics_);
  }

  BinaryOperator op_;
  Span op_span_;
  Operand left_;
  Operand right_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::optional<CheckedExpression> CheckUnaryOperator(UnaryOperator op, Span span,
                                                    CheckedExpression operand,
                                                    Diagnostics& diagnostics) {
  const Type type = operand.type;
  const bool is_not = op == UnaryOperator::kNot;
  const bool fits = is_not ? IsBool(type) : IsNumber(type) && !IsOfQuaternions(type);
  if (!fits) {
    std::string help;
    if (!is_not && IsBool(type))
      help = "a `bool` is not a number: `select(condition, -1, 0)`, or pay inside an `if`";
    Report(diagnostics, code::kWrongOperand, span,
           fmt::format("`{}` cannot be applied to {}", is_not ? "not" : "-", WithArticle(type)),
           {.help = std::move(help)});
    return std::nullopt;
  }
  const Unit unit = operand.unit;
  CheckedUnary node{op, std::make_unique<CheckedExpression>(std::move(operand))};
  return Fold({span, type, unit, std::move(node)}, diagnostics);
}

std::optional<CheckedExpression> CheckBinaryOperator(BinaryOperator op, Span op_span, Operand left,
                                                     Operand right, Diagnostics& diagnostics) {
  return BinaryCheck(op, op_span, std::move(left), std::move(right), diagnostics).Check();
}

std::optional<CheckedExpression> CheckWithin(BinaryOperator op, Span op_span, Operand left,
                                             Operand right, Operand tolerance,
                                             Diagnostics& diagnostics) {
  return BinaryCheck(op, op_span, std::move(left), std::move(right), diagnostics)
      .CheckWithin(std::move(tolerance));
}

}  // namespace compiler
