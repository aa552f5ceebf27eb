#include "compiler/check/composites.h"

#include <cstdlib>
#include <numbers>
#include <utility>

#include "compiler/check/copy_checked.h"
#include "compiler/check/elements.h"
#include "compiler/check/fold.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

// An argument may stand several times in an equation, and equations in each other: this keeps the
// whole small.
constexpr size_t kLargestArgument = 2000;  // nodes

// `normalize` divides by no less: squares of smaller numbers have lost their digits, and directions
// would have any length.
constexpr double kShortestNorm = 1e-150;

const Type kVec3{.shape = Shape::kVector, .rows = 3};

// Writes an equation down. The units of its parts do not matter: that of the whole is known.
class Expansion {
 public:
  Expansion(Span span, std::vector<CheckedExpression> arguments, Diagnostics& diagnostics)
      : span_(span), arguments_(std::move(arguments)), diagnostics_(diagnostics) {}

  std::optional<CheckedExpression> Build(std::variant<Builtin, Composite> function,
                                         const Unit& unit) {
    return Build([&] { return std::visit([&](auto each) { return Equation(each); }, function); },
                 unit);
  }

  std::optional<CheckedExpression> BuildProduct(const Unit& unit) {
    return Build([&] { return QuaternionProduct(); }, unit);
  }

 private:
  template <typename WriteEquation>
  std::optional<CheckedExpression> Build(const WriteEquation& write, const Unit& unit) {
    for (const CheckedExpression& argument : arguments_) {
      if (SizeOf(argument) <= kLargestArgument) continue;
      Report(diagnostics_, code::kTooDeep, argument.span,
             "this is too large to be the argument of such a function",
             {.help = "give parts of it a name with `let`"});
      return std::nullopt;
    }
    CheckedExpression result = write();
    result.unit = unit;
    if (has_failed_) return std::nullopt;
    return result;
  }

  CheckedExpression Equation(Composite function) {
    switch (function) {
      case Composite::kMean:
        return Mean();
      case Composite::kNormalize:
        return Divide(Argument(0),
                      Call(Builtin::kMax, kRealType, Norm(Argument(0)), Number(kShortestNorm)));
      case Composite::kRotate:
        return arguments_[0].type.shape == Shape::kMatrix ? Transformed() : Rotated();
      case Composite::kInverse:
        return Inverse();
      case Composite::kTranspose:
        return Transposed();
      case Composite::kRoll:
        return Angle(0, 1, 2, 3, 1, 2);
      case Composite::kYaw:
        return Angle(0, 3, 1, 2, 2, 3);
      case Composite::kPitch:
        return Pitch();
      case Composite::kAngleBetween:
        return Call(Builtin::kAtan2, kRealType, Norm(Cross(Argument(0), Argument(1))),
                    Call(Builtin::kDot, kRealType, Argument(0), Argument(1)));
      case Composite::kWrap:
        return Subtract(
            Argument(0),
            Multiply(Number(2 * std::numbers::pi),
                     Each(Builtin::kCeil, Divide(Subtract(Argument(0), Number(std::numbers::pi)),
                                                 Number(2 * std::numbers::pi)))));
      case Composite::kTolerance:
        return Tolerance();
    }
    std::abort();
  }

  // Of arrays of vectors.
  CheckedExpression Equation(Builtin function) {
    if (function == Builtin::kCross) return Cross(Argument(0), Argument(1));
    return OfEachColumn(function);
  }

  CheckedExpression OfEachColumn(Builtin function) {
    const Type& type = arguments_[0].type;
    const Type column_type = WithEntries(type, ScalarType(type.scalar));
    BuiltinCall columns{Builtin::kVector, {}};
    for (uint32_t column = 0; column < type.columns; ++column) {
      std::vector<uint32_t> indices;
      for (uint32_t row = 0; row < type.rows; ++row) indices.push_back(row * type.columns + column);
      columns.arguments.push_back(
          Owned(Call(function, kRealType, Picked(Argument(0), std::move(indices), column_type))));
    }
    return Node(EntryOf(type), std::move(columns));
  }

  CheckedExpression Mean() {
    const Type& type = arguments_[0].type;
    if (IsScalar(type)) return Argument(0);
    CheckedExpression sum = HasVectors(type) ? OfEachColumn(Builtin::kSum)
                                             : Call(Builtin::kSum, kRealType, Argument(0));
    return Divide(std::move(sum), Number(type.size() / type.columns));
  }

  CheckedExpression Cross(CheckedExpression a, CheckedExpression b) {
    MakeAlike(a, b);
    if (!HasVectors(a.type)) return Call(Builtin::kCross, kVec3, std::move(a), std::move(b));
    const auto turned = [&](const CheckedExpression& v, uint32_t by) {
      std::vector<uint32_t> indices;
      for (uint32_t i = 0; i < v.type.size(); ++i) indices.push_back(i - i % 3 + (i + by) % 3);
      return Picked(CopyOf(v), std::move(indices), v.type);
    };
    return Subtract(Multiply(turned(a, 1), turned(b, 2)), Multiply(turned(a, 2), turned(b, 1)));
  }

  CheckedExpression Rotated() {
    const auto turn = [&] { return Multiply(Number(2), Cross(Part(0, {1, 2, 3}), Argument(1))); };
    return Add(Add(Argument(1), Multiply(Part(0, {0}), turn())), Cross(Part(0, {1, 2, 3}), turn()));
  }

  CheckedExpression Transformed() {
    const Type& type = arguments_[1].type;
    if (HasVectors(type)) return TransformedVectors(type);
    const auto row = [&](uint32_t i) {
      return Call(Builtin::kDot, kRealType, Part(0, {3 * i, 3 * i + 1, 3 * i + 2}), Argument(1));
    };
    return Call(Builtin::kVector, kVec3, row(0), row(1), row(2));
  }

  // The columns of the matrix, each times an element of the vectors: the same sums.
  CheckedExpression TransformedVectors(const Type& array) {
    const auto summand = [&](uint32_t column) {
      std::vector<uint32_t> factors;
      for (uint32_t i = 0; i < array.size(); ++i) factors.push_back(i - i % 3 + column);
      return Multiply(InEachEntry(Part(0, {column, 3 + column, 6 + column}), array),
                      Picked(Argument(1), std::move(factors), array));
    };
    return Add(Add(summand(0), summand(1)), summand(2));
  }

  CheckedExpression Inverse() {
    const Type& type = arguments_[0].type;
    CheckedExpression signs =
        Call(Builtin::kVector, type, Number(1), Number(-1), Number(-1), Number(-1));
    return Divide(Multiply(Argument(0), std::move(signs)),
                  Call(Builtin::kSum, kRealType, Multiply(Argument(0), Argument(0))));
  }

  // q w + i x + j y + k z of the elements of q, each times the elements of p in their places.
  CheckedExpression QuaternionProduct() {
    const Type& type = arguments_[1].type;
    const auto summand = [&](uint32_t i, std::vector<uint32_t> places, const double(&signs)[4]) {
      CheckedExpression factors = Call(Builtin::kVector, type, Number(signs[0]), Number(signs[1]),
                                       Number(signs[2]), Number(signs[3]));
      return Multiply(Part(0, {i}),
                      Multiply(Picked(Argument(1), std::move(places), type), std::move(factors)));
    };
    return Add(
        Add(Multiply(Part(0, {0}), Argument(1)), summand(1, {1, 0, 3, 2}, {-1, 1, -1, 1})),
        Add(summand(2, {2, 3, 0, 1}, {-1, 1, 1, -1}), summand(3, {3, 2, 1, 0}, {-1, -1, 1, 1})));
  }

  CheckedExpression Transposed() {
    const Type type = arguments_[0].type;
    std::vector<uint32_t> indices;
    for (uint32_t column = 0; column < type.columns; ++column)
      for (uint32_t row = 0; row < type.rows; ++row) indices.push_back(row * type.columns + column);
    return Node(type, Elements{Owned(Argument(0)), std::move(indices)});
  }

  // atan2(2 (q[a] q[b] + q[c] q[d]), 1 - 2 (q[e]^2 + q[f]^2))
  CheckedExpression Angle(uint32_t a, uint32_t b, uint32_t c, uint32_t d, uint32_t e, uint32_t f) {
    CheckedExpression y = Multiply(Number(2), Add(Product(a, b), Product(c, d)));
    CheckedExpression x =
        Subtract(Number(1), Multiply(Number(2), Add(Product(e, e), Product(f, f))));
    return Call(Builtin::kAtan2, kRealType, std::move(y), std::move(x));
  }

  // Rounding must not lead out of what `asin` knows.
  CheckedExpression Pitch() {
    CheckedExpression sine = Multiply(Number(2), Subtract(Product(0, 2), Product(3, 1)));
    return Call(Builtin::kAsin, kRealType,
                Call(Builtin::kClamp, kRealType, std::move(sine), Number(-1), Number(1)));
  }

  CheckedExpression Tolerance() {
    const auto excess = [&] {
      CheckedExpression distance = Each(Builtin::kMax, Subtract(Argument(1), Argument(0)),
                                        Subtract(Argument(0), Argument(2)));
      return Divide(Each(Builtin::kMax, std::move(distance), Number(0)), Argument(3));
    };
    return Each(Builtin::kExp, Multiply(Number(-std::numbers::ln10), Multiply(excess(), excess())));
  }

  // ---- Parts ----

  CheckedExpression Argument(size_t i) const { return CopyOf(arguments_[i]); }

  CheckedExpression Part(size_t argument, std::vector<uint32_t> indices) {
    const Type type = indices.size() == 1 ? kRealType : kVec3;
    return Picked(Argument(argument), std::move(indices), type);
  }
  CheckedExpression Picked(CheckedExpression whole, std::vector<uint32_t> indices,
                           const Type& type) const {
    return PickElements(std::move(whole), std::move(indices), type, span_);
  }
  CheckedExpression Product(uint32_t i, uint32_t j) { return Multiply(Part(0, {i}), Part(0, {j})); }

  CheckedExpression Number(double value) const { return {span_, kRealType, {}, Constant{value}}; }
  CheckedExpression Norm(CheckedExpression v) {
    return Call(Builtin::kNorm, kRealType, std::move(v));
  }

  CheckedExpression Add(CheckedExpression a, CheckedExpression b) {
    return Binary(BinaryOperator::kAdd, std::move(a), std::move(b));
  }
  CheckedExpression Subtract(CheckedExpression a, CheckedExpression b) {
    return Binary(BinaryOperator::kSubtract, std::move(a), std::move(b));
  }
  CheckedExpression Multiply(CheckedExpression a, CheckedExpression b) {
    return Binary(BinaryOperator::kMultiply, std::move(a), std::move(b));
  }
  CheckedExpression Divide(CheckedExpression a, CheckedExpression b) {
    return Binary(BinaryOperator::kDivide, std::move(a), std::move(b));
  }
  CheckedExpression Binary(BinaryOperator op, CheckedExpression a, CheckedExpression b) {
    MakeAlike(a, b);
    const Type type = IsScalar(a.type) ? b.type : a.type;
    return Node(type, CheckedBinary{op, Owned(std::move(a)), Owned(std::move(b))});
  }

  // Of each element of those that are no scalars.
  template <typename... Others>
  CheckedExpression Each(Builtin function, CheckedExpression x, Others... others) {
    Type type = x.type;
    ((type = IsScalar(type) ? others.type : type), ...);
    return Call(function, type, std::move(x), std::move(others)...);
  }

  template <typename... Arguments>
  CheckedExpression Call(Builtin function, const Type& type, Arguments... arguments) {
    BuiltinCall call{function, {}};
    (call.arguments.push_back(Owned(std::move(arguments))), ...);
    return Node(type, std::move(call));
  }

  template <typename AnyNode>
  CheckedExpression Node(const Type& type, AnyNode node) {
    if (has_failed_) return Number(0);
    auto folded = Fold({span_, type, {}, std::move(node)}, diagnostics_);
    if (folded) return std::move(*folded);
    has_failed_ = true;
    return Number(0);
  }

  static CheckedExpressionPtr Owned(CheckedExpression expression) {
    return std::make_unique<CheckedExpression>(std::move(expression));
  }

  const Span span_;
  const std::vector<CheckedExpression> arguments_;
  Diagnostics& diagnostics_;
  bool has_failed_ = false;
};

}  // namespace

std::optional<CheckedExpression> ExpandProduct(CheckedExpression q, CheckedExpression p, Span span,
                                               const Unit& unit, Diagnostics& diagnostics) {
  std::vector<CheckedExpression> factors;
  factors.push_back(std::move(q));
  factors.push_back(std::move(p));
  return Expansion(span, std::move(factors), diagnostics).BuildProduct(unit);
}

std::optional<CheckedExpression> Expand(std::variant<Builtin, Composite> function, Span span,
                                        const Unit& unit, std::vector<CheckedExpression> arguments,
                                        Diagnostics& diagnostics) {
  return Expansion(span, std::move(arguments), diagnostics).Build(function, unit);
}

}  // namespace compiler
