#include "compiler/language_server/declared_names.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace compiler {
namespace {

using testing::ElementsAre;

// "name: type" of each.
std::vector<std::string> NamesIn(const std::string& text) {
  const TextTokens tokens(text);
  std::vector<std::string> names;
  for (const DeclaredName& name : FindDeclaredNames(tokens)) {
    names.push_back(name.type.empty() ? name.name : name.name + ": " + name.type);
  }
  return names;
}

TEST(DeclaredNames, AreFoundInAWholeTask) {
  EXPECT_THAT(
      NamesIn(
          "task t\nsensor base.velocity: vec3 [m/s]\nparam gain: real [1/s] = 4 / s in 0 .. 2\n"
          "const reach: real [m] = 5 cm\nset ends = {0, 3}\n"
          "memory touched: bool[link] = false per action\nmetric max height = log(x)\n"
          "fn near(d: real [m], e: vec3) -> real [1/s] = d\n"
          "on end_of_action {\n  let speed = 1\n  for l in links { log sum touches = 1 }\n"
          "  reward rate up = reward\n  reward += 1\n}\ntest \"works\" { expect reward == 1 }\n"),
      ElementsAre("t", "base.velocity: vec3 [m/s]", "gain: real [1/s]", "reach: real [m]", "ends",
                  "touched: bool[link]", "height", "near: (d: real [m], e: vec3) -> real [1/s]",
                  "d: real [m]", "e: vec3", "end_of_action", "speed", "l", "touches", "up",
                  "\"works\""));
}

TEST(DeclaredNames, AreThoseOfObservationsThatHaveOne) {
  EXPECT_THAT(
      NamesIn("task t\nobserve a.b\nobserve clock = sin(a)\nobserve a.b = 2\nobserve (c)\n"),
      ElementsAre("t", "clock", "a.b"));
}

TEST(DeclaredNames, AreFoundInABrokenText) {
  EXPECT_THAT(NamesIn("task t for\nparam a: real =\nmemory b: \non end_of_action {\nlet c = (\n"
                      "if a { reward d =\nmetric e"),
              ElementsAre("t", "a: real", "b", "end_of_action", "c", "d", "e"));
}

TEST(DeclaredNames, OfAPotentialAreADeclaration) {
  const std::string text =
      "task t\non end_of_action {\n  a = 1\n}\n\nreward potential near = x\nmemory b: int = 0\n";
  const auto names = FindDeclaredNames(TextTokens(text));
  ASSERT_EQ(names.size(), 4u);
  EXPECT_EQ(names[2].name, "near");
  EXPECT_EQ(text.substr(names[2].whole.begin, names[2].whole.end - names[2].whole.begin),
            "reward potential near = x");
}

// Where the name can be used, as text.
std::string VisibilityOf(const std::string& name, const std::string& text) {
  const TextTokens tokens(text);
  for (const DeclaredName& declared : FindDeclaredNames(tokens)) {
    if (declared.name == name)
      return text.substr(declared.visible.begin, declared.visible.end - declared.visible.begin);
  }
  return "absent";
}

TEST(DeclaredNames, AreVisibleInTheirBlocks) {
  const std::string text =
      "task t\nfn f(x: real) -> real {\n  let y = x\n  return y\n}\n"
      "on end_of_action { if a { let b = 1\n b } for i in 0..2 { c = {i} } }\nmemory kept: int = "
      "0\n";
  EXPECT_EQ(VisibilityOf("b", text), " b ");
  EXPECT_EQ(VisibilityOf("i", text), " c = {i} ");
  EXPECT_EQ(VisibilityOf("y", text), "  return y\n");
  EXPECT_EQ(VisibilityOf("x", text), "(x: real) -> real {\n  let y = x\n  return y\n}");
  EXPECT_EQ(VisibilityOf("kept", text), text);
}

TEST(DeclaredNames, KnowTheirWholeDeclaration) {
  const std::string text = "task t\non end_of_action {\n  a = 1\n}\n\nmemory kept: int = 0\n";
  const TextTokens tokens(text);
  const auto names = FindDeclaredNames(tokens);
  ASSERT_EQ(names.size(), 3u);
  EXPECT_EQ(text.substr(names[1].whole.begin, names[1].whole.end - names[1].whole.begin),
            "on end_of_action {\n  a = 1\n}");
}

}  // namespace
}  // namespace compiler
