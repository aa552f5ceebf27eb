#include "compiler/syntax/expression_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "compiler/syntax/parse.h"
#include "compiler/syntax/token_classes.h"
#include "compiler/syntax/unit_builder.h"

namespace compiler {
namespace {

using grammar::TaskParser;

BinaryOperator BinaryOperatorOf(TokenType type) {
  switch (type) {
    case TaskParser::OR:
      return BinaryOperator::kOr;
    case TaskParser::AND:
      return BinaryOperator::kAnd;
    case TaskParser::LESS:
      return BinaryOperator::kLess;
    case TaskParser::LESS_EQUAL:
      return BinaryOperator::kLessEqual;
    case TaskParser::GREATER:
      return BinaryOperator::kGreater;
    case TaskParser::GREATER_EQUAL:
      return BinaryOperator::kGreaterEqual;
    case TaskParser::EQUAL:
      return BinaryOperator::kEqual;
    case TaskParser::NOT_EQUAL:
      return BinaryOperator::kNotEqual;
    case TaskParser::PLUS:
      return BinaryOperator::kAdd;
    case TaskParser::MINUS:
      return BinaryOperator::kSubtract;
    case TaskParser::TIMES:
      return BinaryOperator::kMultiply;
    default:
      return BinaryOperator::kDivide;
  }
}

}  // namespace

Expression ExpressionBuilder::Build(TaskParser::ExpressionContext& context) {
  is_in_index_ = false;
  is_too_deep_ = false;
  Built built = Disjunction(context);
  CheckDepth(SpanOf(context));
  return std::move(*built.expression);
}

std::vector<ExpressionPtr> ExpressionBuilder::BuildSet(TaskParser::ItemsContext& context) {
  is_in_index_ = true;
  is_too_deep_ = false;
  uint32_t depth = 0;
  std::vector<ExpressionPtr> items = Items(context, depth);
  CheckDepth(SpanOf(context));
  return items;
}

void ExpressionBuilder::CheckDepth(Span span) {
  if (!is_too_deep_) return;
  Diagnostic diagnostic = MakeDiagnostic(
      code::kTooDeep, span,
      fmt::format("this expression has more than {} operators in a row", kMaxNesting));
  diagnostic.help = "give parts of it a name with `let`";
  report_.AddMended(std::move(diagnostic));
}

// ---- Operators ---------------------------------------------------------------------------------

ExpressionBuilder::Built ExpressionBuilder::Disjunction(TaskParser::ExpressionContext& context) {
  return Chain(context, &ExpressionBuilder::Conjunction);
}

ExpressionBuilder::Built ExpressionBuilder::Conjunction(TaskParser::ConjunctionContext& context) {
  return Chain(context, &ExpressionBuilder::Negation);
}

ExpressionBuilder::Built ExpressionBuilder::Negation(TaskParser::NegationContext& context) {
  if (context.comparison() != nullptr) return Comparison(*context.comparison());
  return Unary(*context.getStart(), Negation(*context.negation()));
}

ExpressionBuilder::Built ExpressionBuilder::Comparison(TaskParser::ComparisonContext& context) {
  Built left = Sum(*context.sum(0));
  if (context.op == nullptr) return left;
  Built comparison = Binary(std::move(left), *context.op, Sum(*context.sum(1)));
  auto* binary = std::get_if<BinaryExpression>(&comparison.expression->node);
  if (context.tolerance == nullptr || binary == nullptr) return comparison;
  Built tolerance = Sum(*context.tolerance);
  comparison.expression->span = SpanOf(context);
  comparison.depth = std::max(comparison.depth, tolerance.depth + 1);
  binary->tolerance = std::move(tolerance.expression);
  return comparison;
}

ExpressionBuilder::Built ExpressionBuilder::Sum(TaskParser::SumContext& context) {
  return Chain(context, &ExpressionBuilder::Product);
}

ExpressionBuilder::Built ExpressionBuilder::Product(TaskParser::ProductContext& context) {
  return Chain(context, &ExpressionBuilder::Factor);
}

ExpressionBuilder::Built ExpressionBuilder::Factor(TaskParser::FactorContext& context) {
  if (context.postfix() != nullptr) return Postfix(*context.postfix());
  return Unary(*context.getStart(), Factor(*context.factor()));
}

template <typename OperandContext>
ExpressionBuilder::Built ExpressionBuilder::Chain(
    antlr4::ParserRuleContext& context, Built (ExpressionBuilder::*operand)(OperandContext&)) {
  Built result;
  const antlr4::Token* op = nullptr;
  for (antlr4::tree::ParseTree* child : context.children) {
    if (auto* terminal = dynamic_cast<antlr4::tree::TerminalNode*>(child)) {
      op = terminal->getSymbol();
      continue;
    }
    Built next = (this->*operand)(*static_cast<OperandContext*>(child));
    result = op == nullptr ? std::move(next) : Binary(std::move(result), *op, std::move(next));
  }
  return result;
}

ExpressionBuilder::Built ExpressionBuilder::Binary(Built left, const antlr4::Token& op,
                                                   Built right) {
  const Span span = Cover(left.expression->span, right.expression->span);
  const uint32_t depth = std::max(left.depth, right.depth);
  BinaryExpression node{BinaryOperatorOf(op.getType()), SpanOf(op), std::move(left.expression),
                        std::move(right.expression)};
  return Make(span, std::move(node), depth);
}

ExpressionBuilder::Built ExpressionBuilder::Unary(const antlr4::Token& op, Built operand) {
  const Span span = Cover(SpanOf(op), operand.expression->span);
  const UnaryOperator kind =
      op.getType() == TaskParser::NOT ? UnaryOperator::kNot : UnaryOperator::kNegate;
  return Make(span, UnaryExpression{kind, std::move(operand.expression)}, operand.depth);
}

// Beyond the limit the parts are dropped: the expression is an error, and must not grow deeper than
// its destruction can bear.
template <typename Node>
ExpressionBuilder::Built ExpressionBuilder::Make(Span span, Node node, uint32_t depth_below) {
  auto expression = std::make_unique<Expression>();
  expression->span = span;
  if (depth_below >= kMaxNesting) {
    is_too_deep_ = true;
    expression->node = LostExpression{};
    return {std::move(expression), 1};
  }
  expression->node = std::move(node);
  return {std::move(expression), depth_below + 1};
}

// ---- Operands ----------------------------------------------------------------------------------

ExpressionBuilder::Built ExpressionBuilder::Postfix(TaskParser::PostfixContext& context) {
  Built result = Primary(*context.primary());
  for (antlr4::tree::ParseTree* child : context.children) {
    if (auto* member = dynamic_cast<TaskParser::MemberContext*>(child)) {
      const Span span = Cover(result.expression->span, SpanOf(*member));
      MemberExpression node{std::move(result.expression), BuildName(*member->name())};
      result = Make(span, std::move(node), result.depth);
    } else if (auto* selection = dynamic_cast<TaskParser::SelectionContext*>(child)) {
      const Span span = Cover(result.expression->span, SpanOf(*selection));
      const bool was_in_index = std::exchange(is_in_index_, true);
      uint32_t depth = result.depth;
      IndexExpression node{std::move(result.expression), Items(*selection->items(), depth)};
      is_in_index_ = was_in_index;
      result = Make(span, std::move(node), depth);
    } else if (auto* arguments = dynamic_cast<TaskParser::ArgumentsContext*>(child)) {
      result = Method(std::move(result), *arguments);
    }
  }
  return result;
}

ExpressionBuilder::Built ExpressionBuilder::Method(Built result,
                                                   TaskParser::ArgumentsContext& context) {
  const Span span = Cover(result.expression->span, SpanOf(context));
  const Span parenthesis = SpanOf(*context.LEFT_PARENTHESIS()->getSymbol());
  auto* called = std::get_if<MemberExpression>(&result.expression->node);
  if (called == nullptr) return result;  // too deep
  uint32_t depth = result.depth;
  MethodExpression node{std::move(called->object), called->member, parenthesis,
                        Arguments(context, depth)};
  return Make(span, std::move(node), depth);
}

std::vector<ExpressionPtr> ExpressionBuilder::Arguments(TaskParser::ArgumentsContext& context,
                                                        uint32_t& depth) {
  std::vector<ExpressionPtr> arguments;
  for (TaskParser::ExpressionContext* argument : context.expression()) {
    Built built = Disjunction(*argument);
    depth = std::max(depth, built.depth);
    arguments.push_back(std::move(built.expression));
  }
  return arguments;
}

ExpressionBuilder::Built ExpressionBuilder::Primary(TaskParser::PrimaryContext& context) {
  const Span span = SpanOf(context);
  if (auto* number = context.number()) {
    if (auto literal = BuildNumber(*number, report_)) return Make(span, std::move(*literal));
    return Make(span, LostExpression{});
  }
  if (auto* call = context.call()) return Call(*call);
  if (auto* inner = context.expression()) {
    Built result = Disjunction(*inner);
    result.expression->span = span;  // with the parentheses
    return result;
  }
  if (context.items() != nullptr) return Set(context);
  const TokenType type = context.getStart()->getType();
  if (type == TaskParser::TRUE || type == TaskParser::FALSE) {
    return Make(span, BoolLiteral{type == TaskParser::TRUE});
  }
  return Make(span, NameExpression{BuildName(*context.getStart())});
}

ExpressionBuilder::Built ExpressionBuilder::Call(TaskParser::CallContext& context) {
  uint32_t depth = 0;
  CallExpression node{BuildName(*context.callee), Arguments(*context.arguments(), depth)};
  return Make(SpanOf(context), std::move(node), depth);
}

ExpressionBuilder::Built ExpressionBuilder::Set(TaskParser::PrimaryContext& context) {
  if (!is_in_index_) {
    Diagnostic diagnostic = MakeDiagnostic(code::kMisplacedSet, SpanOf(context),
                                           "a set in braces is allowed only inside an index");
    diagnostic.help = "pick elements with it: `contact[links - {body, head}]`";
    report_.AddMended(std::move(diagnostic));
    return Make(SpanOf(context), LostExpression{});
  }
  uint32_t depth = 0;
  SetExpression node{Items(*context.items(), depth)};
  return Make(SpanOf(context), std::move(node), depth);
}

std::vector<ExpressionPtr> ExpressionBuilder::Items(TaskParser::ItemsContext& context,
                                                    uint32_t& depth) {
  std::vector<ExpressionPtr> items;
  for (TaskParser::ItemContext* item : context.item()) {
    Built built = Item(*item);
    depth = std::max(depth, built.depth);
    items.push_back(std::move(built.expression));
  }
  return items;
}

ExpressionBuilder::Built ExpressionBuilder::Item(TaskParser::ItemContext& context) {
  Built first = Disjunction(*context.expression(0));
  if (context.RANGE() == nullptr) return first;
  Built last = Disjunction(*context.expression(1));
  const uint32_t depth = std::max(first.depth, last.depth);
  RangeExpression node{std::move(first.expression), std::move(last.expression)};
  return Make(SpanOf(context), std::move(node), depth);
}

}  // namespace compiler
