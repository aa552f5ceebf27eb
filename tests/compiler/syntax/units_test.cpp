#include <gtest/gtest.h>

#include <string>

#include "tests/compiler/syntax/syntax_text.h"

namespace compiler {
namespace {

std::string ParseUnit(const std::string& unit) {
  const SyntaxTree tree = ParseTask("task t\nsensor a: real " + unit + "\n");
  if (tree.declarations.empty()) return "";
  const auto& sensor = std::get<SensorDeclaration>(tree.declarations.front().node);
  return sensor.unit ? ToText(*sensor.unit) : "";
}

TEST(UnitLiterals, AUnitFollowsItsNumber) {
  EXPECT_EQ(ParseExpression("20 s"), "20[s]");
  EXPECT_EQ(ParseExpression("5ms"), "5[ms]");
  EXPECT_EQ(ParseExpression("0.5 m/s"), "0.5r[m s^-1]");
  EXPECT_EQ(ParseExpression("1 N*m"), "1[N m]");
  EXPECT_EQ(ParseExpression("9.81 m/s^2"), "9.81r[m s^-2]");
  EXPECT_EQ(ParseExpression("2 s^-1"), "2[s^-1]");
  EXPECT_EQ(ParseExpression("3 min"), "3[min]");
}

TEST(UnitLiterals, AUnitMayBeginWithItsOperator) {
  EXPECT_EQ(ParseExpression("4 / s"), "4[s^-1]");
  EXPECT_EQ(ParseExpression("4 * m / s"), "4[m s^-1]");
  EXPECT_EQ(ParseExpression("4 / s^2"), "4[s^-2]");
}

TEST(UnitLiterals, AUnitEndsWhereNoUnitFollows) {
  EXPECT_EQ(ParseExpression("0.25 / 5 ms * dot(a, b)"), "(* (/ 0.25r 5[ms]) (dot a b))");
  EXPECT_EQ(ParseExpression("5 m/s * x"), "(* 5[m s^-1] x)");
  EXPECT_EQ(ParseExpression("5 m / 2 s"), "(/ 5[m] 2[s])");
  EXPECT_EQ(ParseExpression("5 s - 2 s"), "(- 5[s] 2[s])");
}

TEST(UnitLiterals, MinIsAFunctionWhereArgumentsFollow) {
  EXPECT_EQ(ParseExpression("5 m * min(a, b)"), "(* 5[m] (min a b))");
  EXPECT_EQ(ParseExpression("5 / min(a, b)"), "(/ 5 (min a b))");
  EXPECT_EQ(ParseExpression("5 m / min"), "5[m min^-1]");
}

TEST(UnitLiterals, AUnitBelongsToTheSpan) {
  const std::string text = "task t\nmetric x = 5 m/s\n";
  const SyntaxTree tree = ParseTask(text);
  const auto& value = std::get<MetricDeclaration>(tree.declarations.at(0).node).value;
  EXPECT_EQ(value.span, (Span{18, 23}));
  EXPECT_EQ(std::get<NumberLiteral>(value.node).unit->span, (Span{20, 23}));
}

TEST(UnitBrackets, FactorsStandSideBySideOrWithOperators) {
  EXPECT_EQ(ParseUnit("[m/s]"), "[m s^-1]");
  EXPECT_EQ(ParseUnit("[N m]"), "[N m]");
  EXPECT_EQ(ParseUnit("[N*m]"), "[N m]");
  EXPECT_EQ(ParseUnit("[kg m/s^2]"), "[kg m s^-2]");
  EXPECT_EQ(ParseUnit("[1/s]"), "[s^-1]");
  EXPECT_EQ(ParseUnit("[1/s^2]"), "[s^-2]");
  EXPECT_EQ(ParseUnit("[min]"), "[min]");
}

TEST(UnitBrackets, ADivisionSignDividesByOneFactor) {
  EXPECT_EQ(ParseUnit("[J/kg/s]"), "[J kg^-1 s^-1]");
  EXPECT_EQ(ParseUnit("[m/s kg]"), "[m s^-1 kg]");
}

TEST(UnitBrackets, AreNoIndices) {
  const SyntaxTree tree = ParseTask("task t\nsensor a: real[joint] [rad]\nsensor b: real[4] [m]\n");
  const auto& a = std::get<SensorDeclaration>(tree.declarations.at(0).node);
  EXPECT_EQ(ToText(a.type), "real[joint]");
  EXPECT_EQ(ToText(*a.unit), "[rad]");
  const auto& b = std::get<SensorDeclaration>(tree.declarations.at(1).node);
  EXPECT_EQ(ToText(b.type), "real[4]");
  EXPECT_EQ(ToText(*b.unit), "[m]");
}

}  // namespace
}  // namespace compiler
