#include "compiler/bounds/narrowing.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "compiler/bounds/expression_bounds.h"

namespace compiler {
namespace {

// Each case of an `or` is looked at by itself; inside each other they would double at every level.
constexpr int kMostCases = 6;

using enum BinaryOperator;

bool IsComparison(BinaryOperator op) { return op >= kLess && op <= kNotEqual; }

BinaryOperator Opposite(BinaryOperator op) {
  switch (op) {
    case kLess:
      return kGreaterEqual;
    case kLessEqual:
      return kGreater;
    case kGreater:
      return kLessEqual;
    case kGreaterEqual:
      return kLess;
    case kEqual:
      return kNotEqual;
    default:
      return kEqual;
  }
}

// The next value above or below, of which there is none between.
double Above(double value, Scalar scalar) {
  return scalar == Scalar::kReal ? std::nextafter(value, kInfinity) : value + 1;
}
double Below(double value, Scalar scalar) { return -Above(-value, scalar); }

// The numbers of `now` that lie in `range`.
Interval NumbersIn(Interval now, Interval range) {
  now.may_be_nan = false;
  range.may_be_infinite = true;
  return Meet(now, range);
}

double FiniteMagnitude(const Interval& x) {
  return std::max(std::isfinite(x.low) ? std::abs(x.low) : 0,
                  std::isfinite(x.high) ? std::abs(x.high) : 0);
}

// `range`, with room for the rounding of an operation with numbers as large as `scale`.
Interval WithRoom(const Interval& range, double scale) {
  const double room = 8 * std::numeric_limits<double>::epsilon() * scale + 1e-300;
  return {range.low - room, range.high + room};
}

// Factors and divisors with which room for rounding is room enough.
bool IsOrdinary(const Interval& factor) {
  const double least =
      Contains(factor, 0) ? 0 : std::min(std::abs(factor.low), std::abs(factor.high));
  return least >= 1e-20 && Magnitude(factor) <= 1e20;
}

}  // namespace

Interval Narrowing::Of(const CheckedExpression& expression) const {
  return ExpressionBounds(task_, values_).Of(expression);
}

Interval Narrowing::Of(const CheckedExpression& expression, uint32_t element) const {
  if (expression.type.shape == Shape::kScalar) return Of(expression);
  return ExpressionBounds(task_, values_).AllOf(expression)[element];
}

// ---- Conditions -----------------------------------------------------------------------------

bool Narrowing::Assume(const CheckedExpression& condition, bool truth) {
  const Interval now = Of(condition);
  if (!(truth ? MayBeTrue(now) : MayBeFalse(now))) return false;
  if (const auto* unary = std::get_if<CheckedUnary>(&condition.node)) return Assume(*unary, truth);
  if (const auto* binary = std::get_if<CheckedBinary>(&condition.node))
    return Assume(*binary, truth);
  if (const auto* call = std::get_if<BuiltinCall>(&condition.node)) return Assume(*call, truth);
  return Restrict(condition, Exactly(truth ? 1 : 0));
}

bool Narrowing::Assume(const CheckedUnary& unary, bool truth) {
  return Assume(*unary.operand, !truth);
}

bool Narrowing::Assume(const CheckedBinary& binary, bool truth) {
  if (IsComparison(binary.op)) return AssumeComparison(binary, 0, truth);
  const bool are_both = (binary.op == kAnd) == truth;
  if (are_both) return Assume(*binary.left, truth) && Assume(*binary.right, truth);
  return AssumeEither(*binary.left, *binary.right, truth);
}

bool Narrowing::AssumeEither(const CheckedExpression& a, const CheckedExpression& b, bool truth) {
  if (cases_ >= kMostCases) return true;
  ++cases_;
  Values before = values_;
  const bool holds_a = Assume(a, truth);
  Values with_a = std::exchange(values_, std::move(before));
  const bool holds_b = Assume(a, !truth) && Assume(b, truth);
  --cases_;
  if (holds_a && holds_b) {
    values_ = Join(with_a, values_);
  } else if (holds_a) {
    values_ = std::move(with_a);
  }
  return holds_a || holds_b;
}

bool Narrowing::AssumeComparison(const CheckedBinary& comparison, uint32_t element, bool truth) {
  const CheckedExpression& left = *comparison.left;
  const CheckedExpression& right = *comparison.right;
  const auto restrict = [&](const CheckedExpression& operand, const Interval& range) {
    return RestrictElement(operand, element, range);
  };
  const Interval l = Of(left, element);
  const Interval r = Of(right, element);
  const bool may_be_nan = l.may_be_nan || r.may_be_nan;
  // What is not a number differs from all, and all else that is said of it is false.
  if (may_be_nan && truth == (comparison.op == kNotEqual)) return true;
  const Scalar scalar = left.type.scalar;
  switch (truth ? comparison.op : Opposite(comparison.op)) {
    case kLess:
      return restrict(left, {-kInfinity, Below(r.high, scalar)})&& restrict(
          right, {Above(l.low, scalar), kInfinity});
    case kLessEqual:
      return restrict(left, {-kInfinity, r.high})&& restrict(right, {l.low, kInfinity});
    case kGreater:
      return restrict(left, {Above(r.low, scalar), kInfinity})&& restrict(
          right, {-kInfinity, Below(l.high, scalar)});
    case kGreaterEqual:
      return restrict(left, {r.low, kInfinity})&& restrict(right, {-kInfinity, l.high});
    case kEqual:
      return restrict(left, r)&& restrict(right, l);
    default:
      break;
  }
  if (IsExact(r) && l.low == r.low) return restrict(left, {Above(l.low, scalar), kInfinity});
  if (IsExact(r) && l.high == r.low) return restrict(left, {-kInfinity, Below(l.high, scalar)});
  return true;
}

bool Narrowing::Assume(const BuiltinCall& call, bool truth) {
  const CheckedExpression& conditions = *call.arguments.front();
  switch (call.function) {
    case Builtin::kAny:
      return truth ? AssumeSome(conditions, true) : AssumeEach(conditions, false);
    case Builtin::kAll:
      return truth ? AssumeEach(conditions, true) : AssumeSome(conditions, false);
    case Builtin::kNone:
      return truth ? AssumeEach(conditions, false) : AssumeSome(conditions, true);
    case Builtin::kCount:
    case Builtin::kSum:
    case Builtin::kNorm:
    case Builtin::kDot:
    case Builtin::kCross:
    case Builtin::kAbs:
    case Builtin::kMin:
    case Builtin::kMax:
    case Builtin::kClamp:
    case Builtin::kSqrt:
    case Builtin::kExp:
    case Builtin::kLog:
    case Builtin::kTanh:
    case Builtin::kSin:
    case Builtin::kCos:
    case Builtin::kAtan2:
    case Builtin::kTan:
    case Builtin::kAsin:
    case Builtin::kAcos:
    case Builtin::kAtan:
    case Builtin::kPow:
    case Builtin::kSign:
    case Builtin::kFloor:
    case Builtin::kCeil:
    case Builtin::kRound:
    case Builtin::kSelect:
    case Builtin::kVector:
      return true;
  }
  std::abort();
}

bool Narrowing::AssumeEach(const CheckedExpression& conditions, bool truth) {
  if (conditions.type.size() > kTrackedElements) return true;
  for (uint32_t i = 0; i < conditions.type.size(); ++i)
    if (!AssumeElement(conditions, i, truth)) return false;
  return true;
}

// Of several that may hold, nobody knows which; of a single one it is known.
bool Narrowing::AssumeSome(const CheckedExpression& conditions, bool truth) {
  if (conditions.type.shape == Shape::kScalar) return Assume(conditions, truth);
  const Box now = ExpressionBounds(task_, values_).AllOf(conditions);
  if (now.size() != conditions.type.size()) return true;
  const auto fits = [truth](const Interval& x) { return truth ? MayBeTrue(x) : MayBeFalse(x); };
  if (std::ranges::count_if(now.elements(), fits) > 1) return true;
  const auto only = std::ranges::find_if(now.elements(), fits) - now.elements().begin();
  return AssumeElement(conditions, static_cast<uint32_t>(only), truth);
}

bool Narrowing::AssumeElement(const CheckedExpression& conditions, uint32_t element, bool truth) {
  if (conditions.type.shape == Shape::kScalar) return Assume(conditions, truth);
  if (const auto* unary = std::get_if<CheckedUnary>(&conditions.node))
    return AssumeElement(*unary->operand, element, !truth);
  const auto* binary = std::get_if<CheckedBinary>(&conditions.node);
  if (binary == nullptr) return RestrictElement(conditions, element, Exactly(truth ? 1 : 0));
  if (IsComparison(binary->op)) return AssumeComparison(*binary, element, truth);
  const bool are_both = (binary->op == kAnd) == truth;
  return !are_both || (AssumeElement(*binary->left, element, truth) &&
                       AssumeElement(*binary->right, element, truth));
}

// ---- Numbers --------------------------------------------------------------------------------

bool Narrowing::Restrict(const CheckedExpression& expression, const Interval& range) {
  const Interval now = Of(expression);
  const Interval narrowed = NumbersIn(now, range);
  if (narrowed.low > narrowed.high) return false;
  if (narrowed.low == now.low && narrowed.high == now.high && !now.may_be_nan) return true;
  if (Box* box = BoxOf(expression)) {
    box->Set(0, narrowed);
    const auto* local = std::get_if<LocalRead>(&expression.node);
    const CheckedExpression* definition = local ? definitions_[local->local] : nullptr;
    if (definition == nullptr) return true;
    if (definition->type.scalar == Scalar::kBool) return Assume(*definition, narrowed.low >= 1);
    return Restrict(*definition, narrowed);
  }
  if (const auto* elements = std::get_if<Elements>(&expression.node))
    return RestrictElement(*elements->operand, elements->indices.front(), narrowed);
  if (const auto* unary = std::get_if<CheckedUnary>(&expression.node))
    return unary->op == UnaryOperator::kNot || Restrict(*unary->operand, Negate(narrowed));
  if (const auto* conversion = std::get_if<IntToReal>(&expression.node))
    return Restrict(*conversion->operand, {std::ceil(narrowed.low), std::floor(narrowed.high)});
  if (const auto* binary = std::get_if<CheckedBinary>(&expression.node))
    return Restrict(*binary, expression.type.scalar, narrowed);
  if (const auto* call = std::get_if<BuiltinCall>(&expression.node))
    return Restrict(*call, narrowed);
  return true;
}

// Solves for each operand. Integers may have wrapped around: those we leave alone.
bool Narrowing::Restrict(const CheckedBinary& binary, Scalar scalar, const Interval& range) {
  if (scalar != Scalar::kReal) return true;
  const Interval left = Of(*binary.left);
  const Interval right = Of(*binary.right);
  const auto term = [&](BinaryOperator op, const Interval& a, const Interval& b) {
    return WithRoom(Calculate(op, a, b, Scalar::kReal),
                    std::max({FiniteMagnitude(a), FiniteMagnitude(b), FiniteMagnitude(range)}));
  };
  const auto factor = [&](BinaryOperator op, const Interval& other) {
    if (!IsOrdinary(other)) return Interval{};
    const Interval solved = Calculate(op, range, other, Scalar::kReal);
    return WithRoom(solved, FiniteMagnitude(solved));
  };
  switch (binary.op) {
    case kAdd:
      return Restrict(*binary.left, term(kSubtract, range, right)) &&
             Restrict(*binary.right, term(kSubtract, range, left));
    case kSubtract:
      return Restrict(*binary.left, term(kAdd, range, right)) &&
             Restrict(*binary.right, term(kSubtract, left, range));
    case kMultiply:
      return Restrict(*binary.left, factor(kDivide, right)) &&
             Restrict(*binary.right, factor(kDivide, left));
    case kDivide:
      return Restrict(*binary.left, factor(kMultiply, right));
    default:
      return true;
  }
}

bool Narrowing::Restrict(const BuiltinCall& call, const Interval& range) {
  const CheckedExpression& first = *call.arguments.front();
  const bool is_scalar = first.type.shape == Shape::kScalar;
  switch (call.function) {
    case Builtin::kAbs:
      if (Of(first).low >= 0) return Restrict(first, range);
      if (Of(first).high <= 0) return Restrict(first, Negate(range));
      return Restrict(first, {-range.high, range.high});
    case Builtin::kMin:
    case Builtin::kMax: {
      const Interval side = call.function == Builtin::kMin ? Interval{range.low, kInfinity}
                                                           : Interval{-kInfinity, range.high};
      if (is_scalar) return Restrict(first, side) && Restrict(*call.arguments.back(), side);
      for (uint32_t i = 0; i < first.type.size(); ++i)
        if (!RestrictElement(first, i, side)) return false;
      return true;
    }
    case Builtin::kAny:
    case Builtin::kAll:
    case Builtin::kNone:
    case Builtin::kCount:
    case Builtin::kSum:
    case Builtin::kNorm:
    case Builtin::kDot:
    case Builtin::kCross:
    case Builtin::kClamp:
    case Builtin::kSqrt:
    case Builtin::kExp:
    case Builtin::kLog:
    case Builtin::kTanh:
    case Builtin::kSin:
    case Builtin::kCos:
    case Builtin::kAtan2:
    case Builtin::kTan:
    case Builtin::kAsin:
    case Builtin::kAcos:
    case Builtin::kAtan:
    case Builtin::kPow:
    case Builtin::kSign:
    case Builtin::kFloor:
    case Builtin::kCeil:
    case Builtin::kRound:
    case Builtin::kSelect:
    case Builtin::kVector:
      return true;
  }
  std::abort();
}

bool Narrowing::RestrictElement(const CheckedExpression& expression, uint32_t element,
                                const Interval& range) {
  if (expression.type.shape == Shape::kScalar) return Restrict(expression, range);
  if (const auto* elements = std::get_if<Elements>(&expression.node))
    return RestrictElement(*elements->operand, elements->indices[element], range);
  Box* box = BoxOf(expression);
  if (box == nullptr || expression.type.size() > kTrackedElements) return true;
  if (box->size() != expression.type.size())
    *box = Box(std::vector<Interval>(expression.type.size(), (*box)[0]));
  const Interval narrowed = NumbersIn((*box)[element], range);
  if (narrowed.low > narrowed.high) return false;
  box->Set(element, narrowed);
  return true;
}

Box* Narrowing::BoxOf(const CheckedExpression& expression) {
  if (const auto* read = std::get_if<SensorRead>(&expression.node))
    return &values_.sensors[read->sensor];
  if (const auto* read = std::get_if<ParamRead>(&expression.node))
    return &values_.params[read->param];
  if (const auto* read = std::get_if<MemoryRead>(&expression.node))
    return &values_.memory[read->memory];
  if (const auto* read = std::get_if<LocalRead>(&expression.node))
    return &values_.locals[read->local];
  return nullptr;
}

}  // namespace compiler
