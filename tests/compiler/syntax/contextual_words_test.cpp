// Words that are keywords only where a statement or declaration begins.
#include <gtest/gtest.h>

#include <string>

#include "tests/compiler/syntax/syntax_text.h"

namespace compiler {
namespace {

const char* const kWords[] = {"fn",      "import", "extends", "override", "allow",  "after_end",
                              "test",    "given",  "fire",    "expect",   "once",   "set",
                              "const",   "table",  "log",     "require",  "goal",   "redraw",
                              "observe", "phase",  "next",    "return",   "within", "unit"};

class ContextualWord : public testing::TestWithParam<const char*> {};

TEST_P(ContextualWord, IsANameElsewhere) {
  const std::string word = GetParam();
  EXPECT_EQ(ToText(ParseBlock(word + " = 1")), word + " = 1");
  EXPECT_EQ(ToText(ParseBlock(word + " += " + word)), word + " += " + word);
  EXPECT_EQ(ToText(ParseBlock(word + "[2] = a " + word + ".x = " + word)),
            "(at " + word + " 2) = a; " + word + " .x = " + word);
  EXPECT_EQ(ToText(ParseBlock("let " + word + " = (" + word + "\n * a)")),
            "let " + word + " (* " + word + " a)");
  EXPECT_EQ(ToText(ParseBlock("reward rate " + word + " = 1 reward " + word + " = 2")),
            "reward rate " + word + " 1; reward " + word + " 2");
  EXPECT_EQ(ToText(ParseBlock("log max " + word + " = 1 log " + word + " = 2")),
            "log max " + word + " 1; log last " + word + " 2");
  EXPECT_EQ(ToText(ParseBlock("if " + word + " { for " + word + " in " + word + " { } }")),
            "if " + word + " {for " + word + " in " + word + " {}}");
}

TEST_P(ContextualWord, IsANameInDeclarations) {
  const std::string word = GetParam();
  const SyntaxTree tree =
      ParseTask("task " + word + " for " + word + "\nstart " + word + "\nsensor " + word + "." +
                word + ": real\nparam " + word + ": real = 1\nmemory " + word + ": real = " + word +
                "\nmetric max " + word + " = " + word + "\nfn " + word + "(" + word +
                ": real) -> real = " + word + "\ntest \"a\" { given " + word + " = 1 expect " +
                word + " == 1 }\n");
  EXPECT_EQ(tree.task->text, word);
  EXPECT_EQ(tree.declarations.size(), 7u);
}

INSTANTIATE_TEST_SUITE_P(All, ContextualWord, testing::ValuesIn(kWords),
                         [](const auto& word) { return std::string(word.param); });

TEST(ContextualWords, BeginStatementsBehindOthers) {
  EXPECT_EQ(ToText(ParseBlock("n = a log b = n require n < 3 once per run if a { log c = 1 }")),
            "n = a; log last b n; require (< n 3) ''; once run if a {log last c 1}");
}

TEST(ContextualWords, WithinStandsBetweenOperands) {
  EXPECT_EQ(ParseExpression("a == b within 1 and c"), "(and (== a b within 1) c)");
  EXPECT_EQ(ParseExpression("a == b\n within\n -(c)"), "(== a b within (- c))");
  EXPECT_EQ(ParseExpression("within == within within within"), "(== within within within within)");
  EXPECT_EQ(ToText(ParseBlock("let a = b\nwithin = 3")), "let a b; within = 3");
  EXPECT_EQ(ToText(ParseBlock("n = a within = 3 within[2] = 1")),
            "n = a; within = 3; (at within 2) = 1");
}

TEST(ContextualWords, NamePhases) {
  for (const std::string word : kWords) {
    const SyntaxTree tree = ParseTask("task t\nphase " + word + " within 3 s else " + word +
                                      " { next " + word + " n = 1 }\n");
    ASSERT_EQ(tree.declarations.size(), 1u) << word;
    const auto& phase = std::get<PhaseDeclaration>(tree.declarations[0].node);
    EXPECT_EQ(phase.name.text, word);
    EXPECT_EQ(phase.limit->otherwise.text, word);
    EXPECT_EQ(ToText(phase.body), "next " + word + "; n = 1");
  }
}

TEST(ContextualWords, UnitIsOneInTheBracketsOfAType) {
  const SyntaxTree tree = ParseTask(
      "task t\nfn f(unit: real [unit], x: vec3[4] [m unit^2/s], y: real[4] [1/unit]) -> "
      "real [s*unit] = unit + x[unit] + real[unit]\n");
  const auto& function = std::get<FunctionDeclaration>(tree.declarations.at(0).node);
  EXPECT_EQ(function.parameters.at(0).unit->factors.at(0).name.text, kAnyUnit);
  EXPECT_EQ(function.parameters.at(1).unit->factors.at(1).power, 2);
  EXPECT_EQ(function.parameters.at(2).unit->factors.at(0).power, -1);
  EXPECT_EQ(function.unit->factors.at(1).name.text, kAnyUnit);
}

TEST(ContextualWords, LogIsAlsoAFunction) {
  EXPECT_EQ(ParseExpression("log(x) + log(y)"), "(+ (log x) (log y))");
  EXPECT_EQ(ToText(ParseBlock("log log = log(x)")), "log last log (log x)");
}

}  // namespace
}  // namespace compiler
