#include "compiler/bounds/expression_bounds.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/variant/overloaded.h"
#include "compiler/bounds/builtin_bounds.h"
#include "compiler/check/copy_checked.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

// Functions may call functions, each twice or more: what takes longer than this is not looked into.
constexpr int kMostCalls = 2000;
constexpr int kDeepestCall = 50;

// A normal number is made of two uniform ones with 53 bits: sqrt(-2 log(2^-53)), rounded up.
constexpr double kMostDeviations = 8.572;

std::vector<Interval> ElementsOf(const Box& box) {
  return {box.elements().begin(), box.elements().end()};
}

Interval Anything(Scalar scalar) { return scalar == Scalar::kReal ? kAnything : AnyOf(scalar); }

enum class SquareKind { kNone, kSquare, kNegated };

// Of `x * x`, which is never negative, and `-x * x`.
SquareKind SquareKindOf(const CheckedBinary& binary) {
  if (binary.op != BinaryOperator::kMultiply || binary.left->type.scalar != Scalar::kReal)
    return SquareKind::kNone;
  const auto* unary = std::get_if<CheckedUnary>(&binary.left->node);
  const CheckedExpression& left = unary != nullptr ? *unary->operand : *binary.left;
  if (!IsSameRead(left, *binary.right)) return SquareKind::kNone;
  return unary != nullptr ? SquareKind::kNegated : SquareKind::kSquare;
}

Interval Squared(SquareKind kind, const Interval& x) {
  return kind == SquareKind::kNegated ? Negate(Square(x)) : Square(x);
}

}  // namespace

Interval ExpressionBounds::Of(const CheckedExpression& expression) {
  // Without a box for the most frequent ones.
  if (const auto* constant = std::get_if<Constant>(&expression.node))
    return Exactly(constant->value);
  if (const auto* binary = std::get_if<CheckedBinary>(&expression.node)) {
    const SquareKind square = SquareKindOf(*binary);
    if (square != SquareKind::kNone) return Squared(square, Of(*binary->right));
    return compiler::Calculate(binary->op, Of(*binary->left), Of(*binary->right),
                               binary->left->type.scalar);
  }
  return AllOf(expression)[0];
}

Box ExpressionBounds::AllOf(const CheckedExpression& expression) {
  const Type& type = expression.type;
  return std::visit(variant::Overloaded{
                        [](const Constant& node) { return Box(Exactly(node.value)); },
                        [&](const ConstRead& node) {
                          std::vector<Interval> elements;
                          for (const double element : task_.consts[node.index].elements)
                            elements.push_back(Exactly(element));
                          return MakeBox(std::move(elements));
                        },
                        [&](const SensorRead& node) { return values_.sensors[node.sensor]; },
                        [&](const ParamRead& node) { return values_.params[node.param]; },
                        [&](const MemoryRead& node) { return values_.memory[node.memory]; },
                        [&](const LocalRead& node) { return values_.locals[node.local]; },
                        [&](const ArgumentRead& node) { return values_.arguments[node.argument]; },
                        [&](const RewardSoFar&) { return Box(values_.reward); },
                        [&](const TimeStep&) { return Box(values_.time_step); },
                        [&](const Elements& node) { return Calculate(node); },
                        [&](const CheckedUnary& node) {
                          std::vector<Interval> elements = ElementsOf(AllOf(*node.operand));
                          for (Interval& x : elements)
                            x = node.op == UnaryOperator::kNot ? Not(x) : Negate(x);
                          return Box(std::move(elements));
                        },
                        [&](const CheckedBinary& node) {
                          return type.shape == Shape::kScalar ? Box(Of(expression))
                                                              : Calculate(node);
                        },
                        [&](const BuiltinCall& node) { return Calculate(node, type); },
                        [&](const FunctionCall& node) { return Calculate(node, type); },
                        [&](const Draw& node) { return Calculate(node, type); },
                        [&](const TableRead& node) { return Calculate(node); },
                        [&](const CheckedWithin&) { return Box(Anything(type.scalar)); },
                        [&](const TestRead&) { return Box(Anything(type.scalar)); },
                        [&](const IntToReal& node) { return AllOf(*node.operand); },
                    },
                    expression.node);
}

namespace {

// Whether this is what `normalize` stands for: a vector by its norm, which is at least so large
// that the square of any element rounds as other numbers do. No element is then larger than it.
bool IsDirection(const CheckedBinary& binary) {
  const auto* divisor = std::get_if<BuiltinCall>(&binary.right->node);
  if (binary.op != BinaryOperator::kDivide || divisor == nullptr) return false;
  if (divisor->function != Builtin::kMax || divisor->arguments.size() != 2) return false;
  const auto* norm = std::get_if<BuiltinCall>(&divisor->arguments[0]->node);
  return norm != nullptr && norm->function == Builtin::kNorm &&
         IsSame(*norm->arguments[0], *binary.left);
}

void ShortenToOne(Interval& x) {
  if (HasNumber(x)) x = {std::max(x.low, -1.0), std::min(x.high, 1.0), false, x.may_be_nan};
}

}  // namespace

Box ExpressionBounds::Calculate(const CheckedBinary& binary) {
  const SquareKind square = SquareKindOf(binary);
  if (square != SquareKind::kNone) {
    std::vector<Interval> elements = ElementsOf(AllOf(*binary.right));
    for (Interval& x : elements) x = Squared(square, x);
    return Box(std::move(elements));
  }
  const Box left = AllOf(*binary.left);
  const Box right = AllOf(*binary.right);
  std::vector<Interval> elements(std::max(left.size(), right.size()));
  for (size_t i = 0; i < elements.size(); ++i)
    elements[i] = compiler::Calculate(binary.op, left[i], right[i], binary.left->type.scalar);
  if (IsDirection(binary)) std::ranges::for_each(elements, ShortenToOne);
  return Box(std::move(elements));
}

Box ExpressionBounds::Calculate(const Elements& elements) {
  const Box operand = AllOf(*elements.operand);
  std::vector<Interval> picked;
  for (const uint32_t index : elements.indices) picked.push_back(operand[index]);
  return MakeBox(std::move(picked));
}

Box ExpressionBounds::Calculate(const BuiltinCall& call, const Type& type) {
  std::vector<Box> arguments;
  for (const CheckedExpressionPtr& argument : call.arguments) arguments.push_back(AllOf(*argument));
  return BuiltinBounds(call, arguments, type);
}

Box ExpressionBounds::Calculate(const Draw& draw, const Type& type) {
  std::vector<Box> arguments;
  for (const CheckedExpressionPtr& argument : draw.arguments) arguments.push_back(AllOf(*argument));
  std::vector<Interval> elements(type.size());
  for (uint32_t i = 0; i < type.size(); ++i) {
    Interval& element = elements[i] = arguments[0][i];
    if (draw.distribution == Distribution::kNormal) {
      const Interval deviations =
          compiler::Calculate(BinaryOperator::kMultiply, arguments[1][i],
                              {-kMostDeviations, kMostDeviations}, Scalar::kReal);
      element = compiler::Calculate(BinaryOperator::kAdd, element, deviations, Scalar::kReal);
      continue;
    }
    for (const Box& argument : arguments) element = Join(element, argument[i]);
  }
  return MakeBox(std::move(elements));
}

// Of each column. Between two rotations lies a third one, whatever the numbers of the rows.
Box ExpressionBounds::Calculate(const TableRead& read) {
  const CheckedTable& table = task_.tables[read.table];
  const size_t size = table.type.size();
  std::vector<Interval> columns(size, kNothing);
  for (size_t i = 0; i < table.elements.size(); ++i) {
    Interval& column = columns[i % size];
    column.low = std::min(column.low, table.elements[i]);
    column.high = std::max(column.high, table.elements[i]);
  }
  const Interval argument = Of(*read.operand);
  for (Interval& column : columns) {
    if (IsOfQuaternions(table.type)) column = {-1, 1};
    column.may_be_nan = argument.may_be_nan || (read.repeats && argument.may_be_infinite);
  }
  return MakeBox(std::move(columns));
}

Box ExpressionBounds::Calculate(const FunctionCall& call, const Type& type) {
  std::vector<Box> arguments;
  for (const CheckedExpressionPtr& argument : call.arguments) arguments.push_back(AllOf(*argument));
  if (!call.is_each) return Call(call, std::move(arguments), type.scalar);
  // Of arguments that are known by one interval for all elements, so is the result.
  size_t size = 1;
  for (const Box& argument : arguments) size = std::max(size, argument.size());
  std::vector<Interval> elements;
  for (size_t i = 0; i < size; ++i) {
    std::vector<Box> each;
    for (const Box& argument : arguments) each.emplace_back(argument[i]);
    elements.push_back(Call(call, std::move(each), type.scalar)[0]);
  }
  return Box(std::move(elements));
}

Box ExpressionBounds::Call(const FunctionCall& call, std::vector<Box> arguments, Scalar result) {
  if (++calls_ > kMostCalls || depth_ >= kDeepestCall) return Box(Anything(result));
  const CheckedFunction& function = task_.functions[call.function];
  Values inside;
  inside.arguments = std::move(arguments);
  inside.locals.resize(function.locals.size());
  ExpressionBounds body(task_, inside, calls_, depth_ + 1);
  for (const CheckedLet& let : function.lets) inside.locals[let.local] = body.AllOf(let.value);
  return body.AllOf(function.value);
}

Box GoalBounds(const CheckedTask& task, const Values& values, const CheckedGoal& goal) {
  const Box value = ExpressionBounds(task, values).AllOf(goal.value);
  const bool is_each = goal.value.type.shape == Shape::kScalar;
  return is_each ? MakeBox(std::vector<Interval>(goal.type.size(), value[0])) : value;
}

Box TimeFunctionBounds(TimeFunction function, const Box& argument, Scalar scalar,
                       double time_step) {
  std::vector<Interval> elements(argument.size());
  for (size_t i = 0; i < elements.size(); ++i) {
    switch (function) {
      case TimeFunction::kPrevious:
      case TimeFunction::kDelay:
      case TimeFunction::kSmooth:
        elements[i] = argument[i];
        break;
      case TimeFunction::kChange:
        elements[i] =
            compiler::Calculate(BinaryOperator::kSubtract, argument[i], argument[i], scalar);
        break;
      case TimeFunction::kRate:
        elements[i] = kAnything;  // steps may be short
        if (std::isfinite(time_step))
          elements[i] = compiler::Calculate(
              BinaryOperator::kDivide,
              compiler::Calculate(BinaryOperator::kSubtract, argument[i], argument[i], scalar),
              Exactly(time_step), scalar);
        break;
      case TimeFunction::kSince:
        elements[i] = {0, kInfinity};
        break;
      case TimeFunction::kHeld:
      case TimeFunction::kRising:
      case TimeFunction::kFalling:
        elements[i] = kAnyBool;
        break;
    }
  }
  return Box(std::move(elements));
}

bool IsSameRead(const CheckedExpression& a, const CheckedExpression& b) {
  if (a.node.index() != b.node.index()) return false;
  return std::visit(
      variant::Overloaded{
          [&](const SensorRead& node) {
            return node.sensor == std::get<SensorRead>(b.node).sensor;
          },
          [&](const ParamRead& node) { return node.param == std::get<ParamRead>(b.node).param; },
          [&](const MemoryRead& node) {
            return node.memory == std::get<MemoryRead>(b.node).memory;
          },
          [&](const LocalRead& node) { return node.local == std::get<LocalRead>(b.node).local; },
          [&](const ArgumentRead& node) {
            return node.argument == std::get<ArgumentRead>(b.node).argument;
          },
          [&](const Elements& node) {
            const auto& other = std::get<Elements>(b.node);
            return node.indices == other.indices && IsSameRead(*node.operand, *other.operand);
          },
          [](const auto&) { return false; },
      },
      a.node);
}

}  // namespace compiler
