#include "compiler/document/latex.h"

#include <gtest/gtest.h>

#include "tests/compiler/document/parsed.h"

namespace compiler {
namespace {

// LaTeX of an expression as it is written in a task.
std::string Latex(const std::string& expression) {
  return OfExpression(expression, [](const Expression& node) { return ToFormula(node).text; });
}

TEST(Latex, WritesNumbersWithTheirUnits) {
  EXPECT_EQ(Latex("0.25"), "0.25");
  EXPECT_EQ(Latex("20 s"), "20\\,\\mathrm{s}");
  EXPECT_EQ(Latex("3 m/s^2"), "3\\,\\mathrm{m/s^{2}}");
  EXPECT_EQ(Latex("90 deg"), "90^\\circ");
  EXPECT_EQ(Latex("4e-9"), "4 \\times 10^{-9}");
}

TEST(Latex, KnowsTheSignsOfSomeNames) {
  EXPECT_EQ(Latex("time"), "t");
  EXPECT_EQ(Latex("time_step"), "\\Delta t");
  EXPECT_EQ(Latex("pi"), "\\pi");
  EXPECT_EQ(Latex("k"), "k");
  EXPECT_EQ(Latex("sum_of_reward"), "\\mathrm{sum\\_of\\_reward}");
}

TEST(Latex, PutsParenthesesOnlyWhereTheyAreNeeded) {
  EXPECT_EQ(Latex("a + b + c"), "a + b + c");
  EXPECT_EQ(Latex("a - (b + c)"), "a - \\left(b + c\\right)");
  EXPECT_EQ(Latex("(a - b) + c"), "a - b + c");
  EXPECT_EQ(Latex("a + -b"), "a + \\left(-b\\right)");
  EXPECT_EQ(Latex("(a + b) * c"), "\\left(a + b\\right)\\,c");
  EXPECT_EQ(Latex("a * b * c"), "a\\,b\\,c");
  EXPECT_EQ(Latex("a * a"), "a^{2}");
  EXPECT_EQ(Latex("-a * a"), "-a^{2}");
  EXPECT_EQ(Latex("b * (v.x * v.x)"), "b\\,v_{x}^{2}");
  EXPECT_EQ(Latex("(a + b) * (a + b)"), "\\left(a + b\\right)^{2}");
  EXPECT_EQ(Latex("3 * 3"), "3 \\cdot 3");
  EXPECT_EQ(Latex("a * (b / c)"), "a\\,\\frac{b}{c}");
  EXPECT_EQ(Latex("(a + b) / (c - d)"), "\\frac{a + b}{c - d}");
  EXPECT_EQ(Latex("not (a and b)"), "\\lnot \\left(a \\land b\\right)");
  EXPECT_EQ(Latex("not a and (b or c)"), "\\lnot a \\land \\left(b \\lor c\\right)");
  EXPECT_EQ(Latex("a + 1 < b * 2"), "a + 1 < b \\cdot 2");
}

TEST(Latex, PullsTheSignToTheFront) {
  EXPECT_EQ(Latex("-0.5 / 5 ms * a"), "-\\frac{0.5}{5\\,\\mathrm{ms}}\\,a");
  EXPECT_EQ(Latex("-(a + b) * c"), "-\\left(a + b\\right)\\,c");
  EXPECT_EQ(Latex("-a * -b"), "-a\\,\\left(-b\\right)");
}

TEST(Latex, WritesElementsAndSetsAsIndices) {
  EXPECT_EQ(Latex("base.velocity.xy"), "\\mathrm{base.velocity}_{xy}");
  EXPECT_EQ(Latex("contact[body, head]"), "\\mathrm{contact}_{\\mathrm{body},\\,\\mathrm{head}}");
  EXPECT_EQ(Latex("contact[links - {body, head} + feet]"),
            "\\mathrm{contact}_{\\mathrm{links} \\setminus \\{\\mathrm{body},\\,\\mathrm{head}\\} "
            "\\cup \\mathrm{feet}}");
  EXPECT_EQ(Latex("contact[2..7]"), "\\mathrm{contact}_{2\\ldots 7}");
  EXPECT_EQ(Latex("p[feet].z"), "p_{\\mathrm{feet},\\,z}");
  EXPECT_EQ(Latex("p.xy[0, 1][1]"), "p_{xy,\\,\\{0,\\,1\\},\\,1}");
}

TEST(Latex, WritesFunctionsAsMathematicsDoes) {
  EXPECT_EQ(Latex("norm(v)"), "\\left\\lVert v \\right\\rVert");
  EXPECT_EQ(Latex("abs(a + b)"), "\\left\\lvert a + b \\right\\rvert");
  EXPECT_EQ(Latex("sqrt(x)"), "\\sqrt{x}");
  EXPECT_EQ(Latex("2 * dot(a, b)"), "2\\,\\left(a \\cdot b\\right)");
  EXPECT_EQ(Latex("dot(a, b) + 1"), "a \\cdot b + 1");
  EXPECT_EQ(Latex("pow(x + 1, 2)"), "\\left(x + 1\\right)^{2}");
  EXPECT_EQ(Latex("exp(-x)"), "\\exp\\left(-x\\right)");
  EXPECT_EQ(Latex("inverse(q)"), "q^{-1}");
  EXPECT_EQ(Latex("transpose(a + b)"), "\\left(a + b\\right)^{\\top}");
  EXPECT_EQ(Latex("angle_between(v, w)"), "\\operatorname{angle\\_between}\\left(v,\\; w\\right)");
  EXPECT_EQ(Latex("norm(v, w)"), "\\operatorname{norm}\\left(v,\\; w\\right)");
  EXPECT_EQ(Latex("my_own(a, b)"), "\\operatorname{my\\_own}\\left(a,\\; b\\right)");
}

TEST(Equations, SumTheTermsAndGiveTheirCases) {
  EventEquations equations = Equations(
      "reward rate a = x\n"
      "if p { reward b = 1 } else if q { reward c = 2 } else { reward b = 3 }");
  EXPECT_EQ(equations.total.text, "r_{\\text{a}} + r_{\\text{b}} + r_{\\text{c}}");
  ASSERT_EQ(equations.terms.size(), 3u);
  EXPECT_EQ(equations.terms[0].equation.right, "x\\,\\Delta t");
  EXPECT_EQ(equations.terms[1].equation.right,
            "\\begin{cases} 1 & \\text{if } p \\\\ 0 & \\text{if } q \\\\ 3 & \\text{otherwise} "
            "\\end{cases}");
  EXPECT_EQ(equations.terms[2].equation.right,
            "\\begin{cases} 0 & \\text{if } p \\\\ 2 & \\text{if } q \\\\ 0 & \\text{otherwise} "
            "\\end{cases}");
}

TEST(Equations, SumOverLoops) {
  EventEquations equations = Equations("for i in 0..3 { reward a = x[i] + 1 }");
  EXPECT_EQ(equations.terms[0].equation.right,
            "\\sum_{i \\in 0\\ldots 3} \\left(x_{i} + 1\\right)");
}

TEST(Equations, AddSeveralPaymentsOfATerm) {
  EventEquations equations = Equations("reward a = x\nreward a = -y\nreward += z");
  EXPECT_EQ(equations.terms[0].equation.right, "x + \\left(-y\\right)");
  EXPECT_EQ(equations.terms[1].equation.left, "r_{0}");
}

TEST(Equations, GiveEachEndItsConditions) {
  EventEquations equations = Equations(
      "if p { end_episode failure \"one\" } else { if q { end_episode success \"two\" } }\n"
      "truncate_episode \"three\"");
  ASSERT_EQ(equations.ends.size(), 3u);
  EXPECT_EQ(equations.ends[0].condition, "p");
  EXPECT_EQ(equations.ends[1].condition, "\\lnot p \\land q");
  EXPECT_EQ(equations.ends[2].condition, "");
}

TEST(Equations, SayHowMemoryChanges) {
  EventEquations equations = Equations("a = 1\nif p { a -= b + c }\na *= 2");
  ASSERT_EQ(equations.memory.size(), 3u);
  EXPECT_EQ(equations.memory[0].equation.right, "1");
  EXPECT_EQ(equations.memory[1].equation.right, "a - \\left(b + c\\right)");
  EXPECT_EQ(equations.memory[1].condition, "p");
  EXPECT_EQ(equations.memory[2].equation.right, "a \\cdot 2");
}

}  // namespace
}  // namespace compiler
