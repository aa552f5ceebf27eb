#include "compiler/document/reads.h"

#include <gmock/gmock.h>

#include "tests/compiler/document/parsed.h"

namespace compiler {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> Reads(const std::string& expression) {
  return OfExpression(expression, ReadsOf);
}

TEST(Reads, EachNameOnceInTheOrderOfTheText) {
  EXPECT_THAT(Reads("weight * speed + weight"), ElementsAre("weight", "speed"));
  EXPECT_THAT(Reads("clamp(a, -b, 1 m) < c"), ElementsAre("a", "b", "c"));
  EXPECT_THAT(Reads("20 s"), IsEmpty());
}

TEST(Reads, NamesLeadAsFarAsTheyCan) {
  EXPECT_THAT(Reads("norm(base.velocity.xy)"), ElementsAre("base.velocity.xy"));
  EXPECT_THAT(Reads("link.position[left_foot].z"), ElementsAre("link.position[left_foot].z"));
  EXPECT_THAT(Reads("counts[2]"), ElementsAre("counts[2]"));
}

TEST(Reads, SeveralElementsAreReadByTheirName) {
  EXPECT_THAT(Reads("any(contact[links - feet])"), ElementsAre("contact"));
  EXPECT_THAT(Reads("sum(joint.angle[hip, 2..4])"), ElementsAre("joint.angle"));
  EXPECT_THAT(Reads("(a - b).x"), ElementsAre("a", "b"));
}

TEST(Reads, OfATermWithItsConditions) {
  const EventEquations equations = Equations(
      "if low < 0.1 m { reward fall = -penalty } else if high { reward other = 1 }\n"
      "reward rate fall = base.velocity.x\n"
      "let speed = base.velocity.y\n"
      "reward += speed");
  ASSERT_EQ(equations.terms.size(), 3u);
  EXPECT_EQ(equations.terms[0].term, "fall");
  EXPECT_THAT(equations.terms[0].equation.reads, ElementsAre("penalty", "low", "base.velocity.x"));
  EXPECT_THAT(equations.terms[1].equation.reads, ElementsAre("low", "high"));
  EXPECT_EQ(equations.terms[2].term, "reward");
  EXPECT_THAT(equations.terms[2].equation.reads, ElementsAre("speed"));
  EXPECT_THAT(equations.locals[0].reads, ElementsAre("base.velocity.y"));
}

}  // namespace
}  // namespace compiler
