// Swizzles and index sets, as the elements that they pick.
#include <gmock/gmock.h>

#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

using testing::ElementsAre;

std::vector<uint32_t> IndicesOf(const std::string& expression,
                                const std::string& declarations = "") {
  const CheckedExpression checked = CheckText(expression, declarations);
  const auto* elements = std::get_if<Elements>(&checked.node);
  EXPECT_NE(elements, nullptr) << expression;
  return elements != nullptr ? elements->indices : std::vector<uint32_t>{};
}

TEST(Swizzle, PicksElementsByLetter) {
  EXPECT_THAT(IndicesOf("base.velocity.x"), ElementsAre(0));
  EXPECT_THAT(IndicesOf("base.velocity.zx"), ElementsAre(2, 0));
  EXPECT_THAT(IndicesOf("base.velocity.xxyy"), ElementsAre(0, 0, 1, 1));
  EXPECT_EQ(TypeOf("base.velocity.zx"), "vec2 [m/s]");
  EXPECT_EQ(TypeOf("base.velocity.xxyy"), "vec4 [m/s]");
}

TEST(Swizzle, OfAQuaternionCountsFromW) {
  EXPECT_THAT(IndicesOf("base.orientation.w"), ElementsAre(0));
  EXPECT_THAT(IndicesOf("base.orientation.xyz"), ElementsAre(1, 2, 3));
  EXPECT_EQ(TypeOf("base.orientation.xyz"), "vec3");
}

TEST(Swizzle, OfASwizzlePicksFromTheWhole) {
  EXPECT_THAT(IndicesOf("base.velocity.zyx.x"), ElementsAre(2));
  EXPECT_TRUE(std::holds_alternative<SensorRead>(
      std::get<Elements>(CheckText("base.velocity.zyx.x").node).operand->node));
}

TEST(IndexSet, TakesNumbersNamesAndGroups) {
  EXPECT_THAT(IndicesOf("contact[head]"), ElementsAre(1));
  EXPECT_THAT(IndicesOf("contact[body, head]"), ElementsAre(0, 1));
  EXPECT_THAT(IndicesOf("contact[17]"), ElementsAre(17));
  EXPECT_THAT(IndicesOf("contact[hands, head]"), ElementsAre(4, 7, 1));
  EXPECT_THAT(IndicesOf("joint.angle[left_knee_pitch]"), ElementsAre(9));
  EXPECT_EQ(IndicesOf("contact[links]").size(), 18u);
  EXPECT_EQ(IndicesOf("joint.angle[joints]").size(), 17u);
}

TEST(IndexSet, TypeFollowsTheNumberOfElements) {
  EXPECT_EQ(TypeOf("contact[head]"), "bool");
  EXPECT_EQ(TypeOf("contact[body, head]"), "bool[2]");
  EXPECT_EQ(TypeOf("contact[links - {body}]"), "bool[17]");
  EXPECT_EQ(TypeOf("base.velocity[0..1]"), "vec2 [m/s]");
  EXPECT_EQ(TypeOf("base.velocity[1]"), "real [m/s]");
}

TEST(IndexSet, RangesIncludeBothEnds) {
  EXPECT_THAT(IndicesOf("contact[2..5]"), ElementsAre(2, 3, 4, 5));
  EXPECT_THAT(IndicesOf("contact[3..3]"), ElementsAre(3));
  EXPECT_THAT(IndicesOf("contact[left_shoulder..left_hand]"), ElementsAre(2, 3, 4));
}

TEST(IndexSet, DifferencesAndUnionsKeepTheOrder) {
  EXPECT_THAT(IndicesOf("contact[hands + {head, body}]"), ElementsAre(4, 7, 1, 0));
  EXPECT_THAT(IndicesOf("contact[hands - {4}]"), ElementsAre(7));
  EXPECT_THAT(IndicesOf("contact[{5, 2} - feet]"), ElementsAre(5, 2));
}

// The jumping task's second penalty: with names, and with the indices that the paper prints.
TEST(IndexSet, OfAllButTrunkAndFeetIsThatOfThePaper) {
  EXPECT_EQ(IndicesOf("contact[links - {body, head} - feet]"),
            IndicesOf("contact[2..7, 8..11, 13..16]"));
}

TEST(IndexSet, CountsEveryElementOnce) {
  EXPECT_THAT(IndicesOf("contact[head, head]"), ElementsAre(1));
  EXPECT_THAT(IndicesOf("contact[hands, left_hand, 0..1]"), ElementsAre(4, 7, 0, 1));
}

TEST(IndexSet, OfASelectionCountsWithinIt) {
  EXPECT_THAT(IndicesOf("contact[hands][1]"), ElementsAre(7));
}

TEST(MatrixIndex, IsRowAndColumn) {
  EXPECT_THAT(IndicesOf("base.rotation[0, 2]"), ElementsAre(2));
  EXPECT_THAT(IndicesOf("base.rotation[2, 0]"), ElementsAre(6));
  EXPECT_EQ(TypeOf("base.rotation[2, 0]"), "real");
}

TEST(MatrixIndex, WithASetTakesARowOrAColumn) {
  EXPECT_THAT(IndicesOf("base.rotation[0..2, 1]"), ElementsAre(1, 4, 7));
  EXPECT_THAT(IndicesOf("base.rotation[1, 0..2]"), ElementsAre(3, 4, 5));
  EXPECT_EQ(TypeOf("base.rotation[1, 0..2]"), "vec3");
  EXPECT_EQ(TypeOf("base.rotation[1, {0, 2}]"), "vec2");
}

}  // namespace
}  // namespace compiler
