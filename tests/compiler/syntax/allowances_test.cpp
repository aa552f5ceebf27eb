#include <gtest/gtest.h>

#include <string>

#include "tests/compiler/syntax/syntax_text.h"

namespace compiler {
namespace {

// What the allowances of a text cover: "W0706: reward a = 1\n".
std::string Covered(const std::string& text) {
  std::string covered;
  for (const Allowance& allowance : ParseTask(text).allowances) {
    for (const Identifier& code : allowance.codes) covered += code.text + " ";
    const Span span = allowance.covers;
    covered += "| " + text.substr(span.begin, span.end - span.begin) + "\n";
  }
  return covered;
}

TEST(Allowances, CoverTheDeclarationBelow) {
  EXPECT_EQ(Covered("task t\nallow W0701, W0702\n\nmemory a: real = 0\nmemory b: real = 0\n"),
            "W0701 W0702 | memory a: real = 0\n");
}

TEST(Allowances, CoverTheStatementBelow) {
  EXPECT_EQ(Covered("task t\non end_of_action {\n  allow W0705\n  if true {\n    n = 1\n  }\n"
                    "  n = 2\n}\n"),
            "W0705 | if true {\n    n = 1\n  }\n");
}

TEST(Allowances, MayBeginAnywhereInTheirLine) {
  EXPECT_EQ(Covered("task t\non end_of_action {\nallow W0705\n  n = 1\n  if true {\nallow W0706\n"
                    "    n = 2\n  }\n}\n"),
            "W0705 | n = 1\nW0706 | n = 2\n");
}

TEST(Allowances, LeaveItToWhatFollowsWhetherABraceIsMissing) {
  EXPECT_EQ(Errors("task t\non end_of_action {\n  n = 1\nallow W0701\nmemory a: real = 0\n"),
            "E0104 4:12 expected `}` before `memory`\n");
}

TEST(Allowances, CoverTheFileAboveTheHeader) {
  const std::string text = "allow W0707\ntask t\nmemory a: real = 0\n";
  EXPECT_EQ(Covered(text), "W0707 | " + text + "\n");
}

TEST(Allowances, AddUp) {
  EXPECT_EQ(Covered("task t\nallow W0701\nallow W0702\nmemory a: real = 0\n"),
            "W0701 | memory a: real = 0\nW0702 | memory a: real = 0\n");
}

TEST(Allowances, MayStandInTests) {
  EXPECT_EQ(Covered("task t\ntest \"a\" {\n  allow W0711\n  given n = 1\n}\n"),
            "W0711 | given n = 1\n");
}

TEST(Allowances, DoNotHideTheDocumentation) {
  const SyntaxTree tree = ParseTask(
      "/// First.\nallow W0707\n/// Second.\ntask t\n/// A memory.\nallow W0701\n"
      "memory a: real = 0\n");
  EXPECT_EQ(tree.doc, "First.\nSecond.");
  EXPECT_EQ(std::get<MemoryDeclaration>(tree.declarations.at(0).node).doc, "A memory.");
}

TEST(Allowances, NeedSomethingBelow) {
  EXPECT_EQ(Errors("task t\non end_of_action {\n  n = 1\n  allow W0705\n}\nallow W0701\n"),
            "E0124 4:3 nothing follows this `allow`\nE0124 6:1 nothing follows this `allow`\n");
}

}  // namespace
}  // namespace compiler
