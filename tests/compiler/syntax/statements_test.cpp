#include <gtest/gtest.h>

#include <string>

#include "tests/compiler/syntax/syntax_text.h"

namespace compiler {
namespace {

std::string ParseToText(const std::string& statements) { return ToText(ParseBlock(statements)); }

TEST(Statements, Let) { EXPECT_EQ(ParseToText("let speed = norm(v)"), "let speed (norm v)"); }

TEST(Statements, EveryAssignment) {
  EXPECT_EQ(ParseToText("n = 1"), "n = 1");
  EXPECT_EQ(ParseToText("n += 1"), "n += 1");
  EXPECT_EQ(ParseToText("n -= 1"), "n -= 1");
  EXPECT_EQ(ParseToText("n *= 2"), "n *= 2");
  EXPECT_EQ(ParseToText("n /= 2"), "n /= 2");
}

TEST(Statements, AnonymousReward) {
  EXPECT_EQ(ParseToText("reward += 2"), "reward += 2");
  EXPECT_EQ(ParseToText("reward -= 2"), "reward -= 2");
}

TEST(Statements, NamedReward) {
  EXPECT_EQ(ParseToText("reward fall = -4"), "reward fall (- 4)");
  EXPECT_EQ(ParseToText("reward rate forward = v.x"), "reward rate forward v.x");
  EXPECT_EQ(ParseToText("reward rate = 1"), "reward rate 1");
}

TEST(Statements, If) {
  EXPECT_EQ(ParseToText("if a { n = 1 }"), "if a {n = 1}");
  EXPECT_EQ(ParseToText("if a { n = 1 } else { n = 2 }"), "if a {n = 1} else {n = 2}");
  EXPECT_EQ(ParseToText("if a { }\nelse if b { n = 1 }\nelse if c { }\nelse { n = 2 }"),
            "if a {} else if b {n = 1} else if c {} else {n = 2}");
  EXPECT_EQ(ParseToText("if a { if b { n = 1 } else { n = 2 } }"),
            "if a {if b {n = 1} else {n = 2}}");
}

TEST(Statements, Ends) {
  EXPECT_EQ(ParseToText("end_episode success \"done\""), "end success 'done'");
  EXPECT_EQ(ParseToText("end_episode failure \"fell\""), "end failure 'fell'");
  EXPECT_EQ(ParseToText("truncate_episode \"time is up\""), "truncate 'time is up'");
}

TEST(Statements, EscapesInTexts) {
  EXPECT_EQ(ParseToText(R"(truncate_episode "say \"no\" \\ // {")"),
            R"(truncate 'say "no" \ // {')");
  EXPECT_EQ(ParseToText("truncate_episode \"\u00fcber \u20ac\""), "truncate '\u00fcber \u20ac'");
  EXPECT_EQ(ParseToText("truncate_episode \"\""), "truncate ''");
}

TEST(Statements, SeveralInOneLineNeedNothingBetween) {
  EXPECT_EQ(ParseToText("if a { fallen = true reward fall = -1 end_episode failure \"fell\" }"),
            "if a {fallen = true; reward fall (- 1); end failure 'fell'}");
}

TEST(Statements, KnowTheirPlaces) {
  const std::string text =
      "task t\non end_of_action {\n  let x = 3\n  if x > 2 {\n    n = 1\n  }\n}\n";
  const SyntaxTree tree = ParseTask(text);
  const Block& body = std::get<EventDeclaration>(tree.declarations.at(0).node).body;
  ASSERT_EQ(body.size(), 2u);
  EXPECT_EQ(text.substr(body[0].span.begin, body[0].span.end - body[0].span.begin), "let x = 3");
  EXPECT_EQ(text.substr(body[1].span.begin, body[1].span.end - body[1].span.begin),
            "if x > 2 {\n    n = 1\n  }");
}

TEST(Statements, ARewardKeepsItsDocumentation) {
  const Block block = ParseBlock("/// Paid once.\nreward fall = -4\nreward rise = 1");
  ASSERT_EQ(block.size(), 2u);
  EXPECT_EQ(std::get<RewardStatement>(block[0].node).doc, "Paid once.");
  EXPECT_EQ(std::get<RewardStatement>(block[1].node).doc, "");
}

}  // namespace
}  // namespace compiler
