#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/compiler/syntax/syntax_text.h"

namespace compiler {
namespace {

FunctionDeclaration ParseFunction(const std::string& text) {
  SyntaxTree tree = ParseTask(text);
  return std::get<FunctionDeclaration>(std::move(tree.declarations.at(0).node));
}

TEST(Functions, ParametersResultAndValue) {
  const auto function =
      ParseFunction("task t\nfn near(d: real [m], feet: bool[link]) -> real [1/s] = 1 / s * d");
  EXPECT_EQ(function.name.text, "near");
  ASSERT_EQ(function.parameters.size(), 2u);
  EXPECT_EQ(function.parameters[0].name.text, "d");
  EXPECT_EQ(ToText(function.parameters[0].type), "real");
  EXPECT_EQ(ToText(*function.parameters[0].unit), "[m]");
  EXPECT_EQ(ToText(function.parameters[1].type), "bool[link]");
  EXPECT_FALSE(function.parameters[1].unit.has_value());
  EXPECT_EQ(ToText(function.result), "real");
  EXPECT_EQ(ToText(*function.unit), "[s^-1]");
  EXPECT_TRUE(function.lets.empty());
  EXPECT_EQ(ToText(function.value), "(* 1[s^-1] d)");
}

TEST(Functions, ABodyHasLetsAndAReturn) {
  const auto function = ParseFunction(
      "task t\nfn f(a: real) -> real {\n  let b = a * a\n  let c = b + 1\n  return -c\n}\n");
  ASSERT_EQ(function.lets.size(), 2u);
  EXPECT_EQ(function.lets[1].name.text, "c");
  EXPECT_EQ(ToText(function.lets[1].value), "(+ b 1)");
  EXPECT_EQ(ToText(function.value), "(- c)");
}

TEST(Functions, MayHaveNoParametersAndStandInOneLine) {
  EXPECT_EQ(ToText(ParseFunction("task t\nfn f() -> int = 3").value), "3");
  EXPECT_EQ(ToText(ParseFunction("task t\nfn f() -> int { return 3 }").value), "3");
}

TEST(Functions, HeadsMaySpanLines) {
  const auto function =
      ParseFunction("task t\nfn f(a: real,\n     b: real)\n    -> real =\n    a + b\n");
  EXPECT_EQ(function.parameters.size(), 2u);
  EXPECT_EQ(ToText(function.value), "(+ a b)");
}

TEST(Functions, KeepTheirDocumentation) {
  EXPECT_EQ(ParseFunction("task t\n/// Small.\nfn f() -> int = 3").doc, "Small.");
}

}  // namespace
}  // namespace compiler
