#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/compiler/syntax/syntax_text.h"

namespace compiler {
namespace {

TestDeclaration ParseTest(const std::string& text) {
  SyntaxTree tree = ParseTask("task t for humanoid\n" + text);
  return std::get<TestDeclaration>(std::move(tree.declarations.at(0).node));
}

std::string Statements(const std::string& statements) {
  std::string text;
  for (const TestStatement& statement :
       ParseTest("test \"a\" {\n" + statements + "\n}\n").statements) {
    if (!text.empty()) text += "; ";
    text += ToText(statement);
  }
  return text;
}

TEST(Tests, NameAndDocumentation) {
  const TestDeclaration test = ParseTest("/// As in the paper.\ntest \"a \\\"fall\\\"\" { }");
  EXPECT_EQ(test.name, "a \"fall\"");
  EXPECT_EQ(test.doc, "As in the paper.");
  EXPECT_TRUE(test.statements.empty());
}

TEST(Tests, GivenTakesSensorsParamsAndMemory) {
  EXPECT_EQ(Statements("given contact[head] = true"), "given (at contact head) = true");
  EXPECT_EQ(Statements("given base.velocity = vec3(1 m/s, 0, 0)"),
            "given base.velocity = (vec3 1[m s^-1] 0 0)");
  EXPECT_EQ(Statements("given base.velocity.x = 1 m/s"), "given base.velocity .x = 1[m s^-1]");
  EXPECT_EQ(Statements("given joint.angle[knee, hip] = 30 deg"),
            "given (at joint.angle knee hip) = 30[deg]");
  EXPECT_EQ(Statements("given time_step = 5 ms"), "given time_step = 5[ms]");
}

TEST(Tests, FireTakesEventsAndHowOften) {
  EXPECT_EQ(Statements("fire start_of_action, 100 * end_of_time_step"),
            "fire 1*start_of_action 100*end_of_time_step");
}

TEST(Tests, ExpectTakesConditionsAndEnds) {
  EXPECT_EQ(Statements("expect total(fall) == -4"), "expect (== (total fall) (- 4))");
  EXPECT_EQ(Statements("expect (ended)"), "expect ended");
  EXPECT_EQ(Statements("expect end_episode failure \"fell\""), "expect end failure 'fell'");
  EXPECT_EQ(Statements("expect truncate_episode \"late\""), "expect truncate 'late'");
}

TEST(Tests, StatementsMayShareALine) {
  EXPECT_EQ(Statements("given n = 3 fire end_of_action expect n == 3 expect reward == 1"),
            "given n = 3; fire 1*end_of_action; expect (== n 3); expect (== reward 1)");
}

}  // namespace
}  // namespace compiler
