#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "compiler/syntax/syntax_tree.h"
#include "tests/compiler/syntax/syntax_text.h"

namespace compiler {
namespace {

TEST(Expressions, Literals) {
  EXPECT_EQ(ParseExpression("3"), "3");
  EXPECT_EQ(ParseExpression("3.5"), "3.5r");
  EXPECT_EQ(ParseExpression("4e-9"), "4e-09r");
  EXPECT_EQ(ParseExpression("1.5E+3"), "1500r");
  EXPECT_EQ(ParseExpression("true"), "true");
  EXPECT_EQ(ParseExpression("false"), "false");
  EXPECT_EQ(ParseExpression("fallen"), "fallen");
  EXPECT_EQ(ParseExpression("reward"), "reward");
}

TEST(Expressions, NumbersAreReadExactly) {
  const Block block = ParseBlock("let x = 0.1\nlet y = 9007199254740992");
  const auto& x = std::get<LetStatement>(block.at(0).node).value;
  const auto& y = std::get<LetStatement>(block.at(1).node).value;
  EXPECT_EQ(std::get<NumberLiteral>(x.node).value, 0.1);
  EXPECT_EQ(std::get<NumberLiteral>(y.node).value, 9007199254740992.0);
  EXPECT_TRUE(std::get<NumberLiteral>(y.node).is_integer);
}

TEST(Expressions, PrecedenceFromLooseToTight) {
  EXPECT_EQ(ParseExpression("a or b and c"), "(or a (and b c))");
  EXPECT_EQ(ParseExpression("a and b or c"), "(or (and a b) c)");
  EXPECT_EQ(ParseExpression("not a and b"), "(and (not a) b)");
  EXPECT_EQ(ParseExpression("not a < b"), "(not (< a b))");
  EXPECT_EQ(ParseExpression("a + b < c * d"), "(< (+ a b) (* c d))");
  EXPECT_EQ(ParseExpression("a + b * c"), "(+ a (* b c))");
  EXPECT_EQ(ParseExpression("-a * b"), "(* (- a) b)");
  EXPECT_EQ(ParseExpression("-a.x"), "(- a.x)");
  EXPECT_EQ(ParseExpression("-norm(a).x"), "(- (norm a).x)");
}

TEST(Expressions, OperatorsOfOneRankGroupFromTheLeft) {
  EXPECT_EQ(ParseExpression("a - b - c"), "(- (- a b) c)");
  EXPECT_EQ(ParseExpression("a / b * c"), "(* (/ a b) c)");
  EXPECT_EQ(ParseExpression("a - b + c"), "(+ (- a b) c)");
  EXPECT_EQ(ParseExpression("a or b or c"), "(or (or a b) c)");
}

TEST(Expressions, ParenthesesOverrideAndBelongToTheSpan) {
  EXPECT_EQ(ParseExpression("(a + b) * c"), "(* (+ a b) c)");
  EXPECT_EQ(ParseExpression("not (a and b)"), "(not (and a b))");
  const std::string text = "task t\nmetric x = (a + b) * c\n";
  const SyntaxTree tree = ParseTask(text);
  const auto& value = std::get<MetricDeclaration>(tree.declarations.at(0).node).value;
  EXPECT_EQ(text.substr(value.span.begin, value.span.end - value.span.begin), "(a + b) * c");
  const auto& product = std::get<BinaryExpression>(value.node);
  EXPECT_EQ(text.substr(product.op_span.begin, 1), "*");
  EXPECT_EQ(product.left->span, (Span{18, 25}));
}

TEST(Expressions, EveryComparison) {
  EXPECT_EQ(ParseExpression("a < b"), "(< a b)");
  EXPECT_EQ(ParseExpression("a <= b"), "(<= a b)");
  EXPECT_EQ(ParseExpression("a > b"), "(> a b)");
  EXPECT_EQ(ParseExpression("a >= b"), "(>= a b)");
  EXPECT_EQ(ParseExpression("a == b"), "(== a b)");
  EXPECT_EQ(ParseExpression("a != b"), "(!= a b)");
}

TEST(Expressions, SignsMayBeRepeated) {
  EXPECT_EQ(ParseExpression("a - -b"), "(- a (- b))");
  EXPECT_EQ(ParseExpression("not not a"), "(not (not a))");
}

TEST(Expressions, MembersAndSwizzles) {
  EXPECT_EQ(ParseExpression("base.velocity.xy"), "base.velocity.xy");
  EXPECT_EQ(ParseExpression("joint.angle[neck_yaw].x"), "(at joint.angle neck_yaw).x");
}

TEST(Expressions, IndicesRangesAndSets) {
  EXPECT_EQ(ParseExpression("contact[body, head]"), "(at contact body head)");
  EXPECT_EQ(ParseExpression("contact[2..7, 8..11]"), "(at contact 2..7 8..11)");
  EXPECT_EQ(ParseExpression("contact[links - {body, head} - feet]"),
            "(at contact (- (- links (set body head)) feet))");
  EXPECT_EQ(ParseExpression("contact[{2..7, head} + feet]"),
            "(at contact (+ (set 2..7 head) feet))");
  EXPECT_EQ(ParseExpression("contact[(feet)]"), "(at contact feet)");
}

TEST(Expressions, Calls) {
  EXPECT_EQ(ParseExpression("norm(v)"), "(norm v)");
  EXPECT_EQ(ParseExpression("clamp(a, 0, 1 + b)"), "(clamp a 0 (+ 1 b))");
  EXPECT_EQ(ParseExpression("min(a, b)"), "(min a b)");
  EXPECT_EQ(ParseExpression("now()"), "(now)");
}

TEST(Expressions, KnowTheirPlaces) {
  const std::string text = "task t\nmetric x = any(contact[links - {body}])\n";
  const SyntaxTree tree = ParseTask(text);
  const auto& call = std::get<MetricDeclaration>(tree.declarations.at(0).node).value;
  EXPECT_EQ(call.span, (Span{18, 46}));
  const auto& index = *std::get<CallExpression>(call.node).arguments.at(0);
  EXPECT_EQ(index.span, (Span{22, 45}));
  const auto& difference = *std::get<IndexExpression>(index.node).items.at(0);
  EXPECT_EQ(difference.span, (Span{30, 44}));
  EXPECT_EQ(std::get<BinaryExpression>(difference.node).right->span, (Span{38, 44}));
}

}  // namespace
}  // namespace compiler
