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

// Of arrays of vectors, with the memories that they are elements of.
constexpr const char* kArrays =
    "memory p: vec3[link] [m] = 0\n"
    "memory v: vec3[link] [m/s] = 0\n"
    "memory few: vec3[4] [m] = 0\n"
    "memory turns: quat[link] = 0\n"
    "memory mass: real[link] [kg] = 1 kg";

TEST(VectorArray, IsIndexedByItsVectors) {
  EXPECT_THAT(IndicesOf("p[head]", kArrays), ElementsAre(3, 4, 5));
  EXPECT_THAT(IndicesOf("p[hands]", kArrays), ElementsAre(12, 13, 14, 21, 22, 23));
  EXPECT_EQ(TypeOf("p", kArrays), "vec3[link] [m]");
  EXPECT_EQ(TypeOf("p[head]", kArrays), "vec3 [m]");
  EXPECT_EQ(TypeOf("p[hands]", kArrays), "vec3[2] [m]");
  EXPECT_EQ(TypeOf("few[3]", kArrays), "vec3 [m]");
  EXPECT_EQ(TypeOf("turns[head]", kArrays), "quat");
}

TEST(VectorArray, GivesAMemberOfEachVector) {
  EXPECT_THAT(IndicesOf("p[hands].z", kArrays), ElementsAre(14, 23));
  EXPECT_THAT(IndicesOf("p[hands].zx", kArrays), ElementsAre(14, 12, 23, 21));
  EXPECT_EQ(TypeOf("p.z", kArrays), "real[link] [m]");
  EXPECT_EQ(TypeOf("p[hands].z", kArrays), "real[2] [m]");
  EXPECT_EQ(TypeOf("p.xy", kArrays), "vec2[link] [m]");
  EXPECT_EQ(TypeOf("turns.w", kArrays), "real[link]");
  EXPECT_EQ(TypeOf("turns[feet].xyz", kArrays), "vec3[2]");
}

TEST(VectorArray, MayBeIndexedOnAndOn) {
  EXPECT_THAT(IndicesOf("p[head][2]", kArrays), ElementsAre(5));
  EXPECT_THAT(IndicesOf("p.z[head]", kArrays), ElementsAre(5));
  EXPECT_THAT(IndicesOf("p[hands][1].xy", kArrays), ElementsAre(21, 22));
  EXPECT_THAT(IndicesOf("p.zyx[head].x", kArrays), ElementsAre(5));
}

TEST(VectorArray, IsCalculatedWithVectorByVector) {
  EXPECT_EQ(TypeOf("p + p", kArrays), "vec3[link] [m]");
  EXPECT_EQ(TypeOf("2 * p", kArrays), "vec3[link] [m]");
  EXPECT_EQ(TypeOf("-p / 1 s - v", kArrays), "vec3[link] [m/s]");
  EXPECT_EQ(TypeOf("p - base.position", kArrays), "vec3[link] [m]");
  EXPECT_EQ(TypeOf("base.velocity - v[feet]", kArrays), "vec3[2] [m/s]");
  EXPECT_EQ(TypeOf("mass * v", kArrays), "vec3[link] [kg m/s]");
  EXPECT_EQ(TypeOf("v / mass", kArrays), "vec3[link] [m/kg/s]");
  EXPECT_EQ(TypeOf("p.xy * 2", kArrays), "vec2[link] [m]");
}

TEST(VectorArray, GivesOneResultForEachVector) {
  EXPECT_EQ(TypeOf("norm(p)", kArrays), "real[link] [m]");
  EXPECT_EQ(TypeOf("norm(p[feet])", kArrays), "real[2] [m]");
  EXPECT_EQ(TypeOf("dot(p, v)", kArrays), "real[link] [m^2/s]");
  EXPECT_EQ(TypeOf("dot(base.up, p)", kArrays), "real[link] [m]");
  EXPECT_EQ(TypeOf("cross(p, base.up)", kArrays), "vec3[link] [m]");
  EXPECT_EQ(TypeOf("rotate(base.orientation, p)", kArrays), "vec3[link] [m]");
  EXPECT_EQ(TypeOf("rotate(base.rotation, p[feet])", kArrays), "vec3[2] [m]");
  EXPECT_EQ(TypeOf("max(norm(v[links - feet]))", kArrays), "real [m/s]");
}

TEST(VectorArray, IsJoinedElementByElement) {
  EXPECT_EQ(TypeOf("sum(p)", kArrays), "vec3 [m]");
  EXPECT_EQ(TypeOf("mean(p[feet])", kArrays), "vec3 [m]");
  EXPECT_EQ(TypeOf("min(p.xy)", kArrays), "vec2 [m]");
  EXPECT_EQ(TypeOf("min(p.z)", kArrays), "real [m]");
}

TEST(VectorArray, OfConstantsGivesConstants) {
  const CheckedExpression z = CheckText("vec3(1, 2, 3).z");
  EXPECT_EQ(std::get<Constant>(z.node).value, 3);
}

TEST(RobotConstant, IsKnownToTheCompiler) {
  EXPECT_EQ(TypeOf("joint.low"), "real[joint] [rad]");
  EXPECT_EQ(TypeOf("joint.angle - joint.rest"), "real[joint] [rad]");
  EXPECT_EQ(TypeOf("joint.high[legs]"), "real[10] [rad]");
  const robot::Joint& knee = Humanoid().joints[Humanoid().FindJoint("left_knee_pitch").value()];
  const CheckedExpression high = CheckText("joint.high[left_knee_pitch]");
  EXPECT_EQ(std::get<Constant>(high.node).value, knee.high);
  const CheckedTask task =
      CheckTask(TaskText("param p: real [rad] = joint.low[left_knee_pitch]", "reward rate a = p"));
  EXPECT_EQ(task.params[0].initial, knee.low);
  EXPECT_TRUE(task.sensors.empty());
}

}  // namespace
}  // namespace compiler
