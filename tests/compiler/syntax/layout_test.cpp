#include <gtest/gtest.h>

#include <string>

#include "tests/compiler/syntax/syntax_text.h"

namespace compiler {
namespace {

TEST(LineEnds, AStatementEndsWithItsLine) {
  EXPECT_EQ(ToText(ParseBlock("let a = b\nlet c = d")), "let a b; let c d");
}

TEST(LineEnds, ALineNeverSilentlyJoinsTheOneAbove) {
  EXPECT_EQ(Errors("task t\non end_of_action {\n  let a = b\n  -c\n}\n"),
            "E0106 4:3 a line cannot begin with `-`\n");
}

TEST(LineEnds, AnOperatorAtTheEndContinuesTheLine) {
  EXPECT_EQ(ParseExpression("a +\n b"), "(+ a b)");
  EXPECT_EQ(ParseExpression("a -\n\n  // a comment\n b"), "(- a b)");
  EXPECT_EQ(ParseExpression("a *  // a comment\n b"), "(* a b)");
  EXPECT_EQ(ParseExpression("a and\n not\n b"), "(and a (not b))");
  EXPECT_EQ(ParseExpression("a <\n b"), "(< a b)");
  EXPECT_EQ(ParseExpression("\n b"), "b");
}

TEST(LineEnds, BracketsContinueTheLine) {
  EXPECT_EQ(ParseExpression("(a\n + b\n)"), "(+ a b)");
  EXPECT_EQ(ParseExpression("contact[\n body,\n head\n]"), "(at contact body head)");
  EXPECT_EQ(ParseExpression("contact[links\n - {body,\n head}]"),
            "(at contact (- links (set body head)))");
  EXPECT_EQ(ParseExpression("clamp(a,\n b\n, c)"), "(clamp a b c)");
}

TEST(LineEnds, BracesAndElseMayBeginALine) {
  EXPECT_EQ(ToText(ParseBlock("if a\n{\n n = 1\n}\nelse\n{\n n = 2\n}\nn = 3")),
            "if a {n = 1} else {n = 2}; n = 3");
}

TEST(LineEnds, RangesAndScopesMayBeginALine) {
  const SyntaxTree tree =
      ParseTask("task t\nparam p: real = 1\n  in 0 .. 2\nmemory a: real = 0\n  per run\n");
  ASSERT_EQ(tree.declarations.size(), 2u);
  EXPECT_TRUE(std::get<ParamDeclaration>(tree.declarations[0].node).maximum.has_value());
}

TEST(LineEnds, CarriageReturnsAndBlankLinesDoNotMatter) {
  const SyntaxTree tree = ParseTask(
      "\r\n\r\ntask t for humanoid\r\n\r\n\r\non end_of_action {\r\n\r\n  n = 1\r\n}\r\n\r\n");
  EXPECT_EQ(ToText(std::get<EventDeclaration>(tree.declarations.at(0).node).body), "n = 1");
}

TEST(LineEnds, TheLastLineNeedsNone) {
  EXPECT_EQ(ParseTask("task t\nmetric d = x").declarations.size(), 1u);
  EXPECT_EQ(ParseTask("task t // the end").task->text, "t");
}

TEST(LineEnds, AByteOrderMarkIsSkipped) {
  EXPECT_EQ(ParseTask("\xEF\xBB\xBFtask t\n").task->span, (Span{8, 9}));
}

TEST(Brackets, AMissingBraceIsFoundWhereTheNextDeclarationBegins) {
  EXPECT_EQ(Errors("task t\non end_of_action {\n  n = 1\n\non end_of_episode {\n  n = 2 2\n}\n"),
            "E0104 3:8 expected `}` before `on`\n"
            "E0101 6:9 expected an operator or the end of the line, found `2`\n");
}

TEST(Brackets, AMissingBracketCostsOneMessage) {
  EXPECT_EQ(Errors("task t\non end_of_action {\n  n = (1 + 2\n  let a = b[c\n  n = 3\n}\n"),
            "E0104 3:13 expected `)` before `let`\n"
            "E0104 4:14 expected `]` before `n`\n");
}

TEST(Brackets, AWrongOneCostsOneMessage) {
  EXPECT_EQ(Errors("task t\nmetric d = norm(a]\nmetric e = b[{c, d)]\n"),
            "E0105 2:18 `]` does not close `(`\n"
            "E0105 3:19 `)` does not close `{`\n");
}

}  // namespace
}  // namespace compiler
