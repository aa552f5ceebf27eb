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

TEST(Statements, Elements) {
  EXPECT_EQ(ParseToText("touched[feet] = false"), "(at touched feet) = false");
  EXPECT_EQ(ParseToText("place.xy += 1 m"), "place .xy += 1[m]");
  EXPECT_EQ(ParseToText("last[feet].z = 0 m"), "(at last feet) .z = 0[m]");
  EXPECT_EQ(ParseToText("turn[2, 0] *= 2"), "(at turn 2 0) *= 2");
  EXPECT_EQ(ParseToText("touched[links - {body, head}] = true"),
            "(at touched (- links (set body head))) = true");
  EXPECT_EQ(ParseToText("base.velocity = 0"), "base.velocity = 0");
}

TEST(Statements, Redraw) { EXPECT_EQ(ParseToText("redraw target n = 1"), "redraw target; n = 1"); }

TEST(Statements, For) {
  EXPECT_EQ(ParseToText("for l in links - feet { n += 1 }"), "for l in (- links feet) {n += 1}");
  EXPECT_EQ(ParseToText("for i in 0..3, 7 { }"), "for i in 0..3 7 {}");
  EXPECT_EQ(ParseToText("for l in {body, head} { }"), "for l in (set body head) {}");
  EXPECT_EQ(ParseToText("for l in links - {body, head} - feet\n{ n = 1 }"),
            "for l in (- (- links (set body head)) feet) {n = 1}");
  EXPECT_EQ(ParseToText("for l in body,\n head { for i in 0..1 { } }"),
            "for l in body head {for i in 0..1 {}}");
}

TEST(Statements, Once) {
  EXPECT_EQ(ParseToText("once per action if a { n = 1 }"), "once action if a {n = 1}");
  EXPECT_EQ(ParseToText("once per episode if a { }"), "once episode if a {}");
  EXPECT_EQ(ParseToText("once per action if a { n = 1 }\nelse if b { } else if c { n = 2 }"),
            "once action if a {n = 1} else if b {} else if c {n = 2}");
  EXPECT_EQ(ParseToText("once per run if a { once per run if b { } }"),
            "once run if a {once run if b {}}");
}

TEST(Statements, Log) {
  EXPECT_EQ(ParseToText("log speed = v.x"), "log last speed v.x");
  EXPECT_EQ(ParseToText("log max speed = v.x"), "log max speed v.x");
  EXPECT_EQ(ParseToText("log min speed = v.x"), "log min speed v.x");
  EXPECT_EQ(ParseToText("log mean = v.x"), "log last mean v.x");
}

TEST(Statements, Require) {
  EXPECT_EQ(ParseToText("require a < 3"), "require (< a 3) ''");
  EXPECT_EQ(ParseToText("require (a) and -b < 3 \"stays small\""),
            "require (and a (< (- b) 3)) 'stays small'");
  EXPECT_EQ(ParseToText("require -b < 3"), "require (< (- b) 3) ''");
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

TEST(Statements, ALogKeepsItsDocumentation) {
  const Block block = ParseBlock("/// How fast.\nlog speed = v");
  EXPECT_EQ(std::get<LogStatement>(block.at(0).node).doc, "How fast.");
}

}  // namespace
}  // namespace compiler
