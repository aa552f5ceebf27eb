#include "compiler/check/builtins.h"

#include <gmock/gmock.h>

#include "tests/compiler/check/checked_source.h"
#include "tests/golden.h"

namespace compiler {
namespace {

TEST(Builtins, ReduceConditions) {
  EXPECT_EQ(TypeOf("any(contact)"), "bool");
  EXPECT_EQ(TypeOf("all(contact[hands, head])"), "bool");
  EXPECT_EQ(TypeOf("none(contact[head])"), "bool");
  EXPECT_EQ(TypeOf("count(contact[feet])"), "int");
}

TEST(Builtins, ReduceNumbers) {
  EXPECT_EQ(TypeOf("sum(joint.angle)"), "real [rad]");
  EXPECT_EQ(TypeOf("sum(n)", "memory n: int[3] = 0"), "int");
  EXPECT_EQ(TypeOf("max(joint.angle)"), "real [rad]");
  EXPECT_EQ(TypeOf("min(base.velocity)"), "real [m/s]");
  EXPECT_EQ(TypeOf("norm(joint.torque)"), "real [N m]");
  EXPECT_EQ(TypeOf("norm(n)", "memory n: int[3] = 0"), "real");
}

TEST(Builtins, MultiplyVectors) {
  EXPECT_EQ(TypeOf("dot(base.velocity, base.position)"), "real [m^2/s]");
  EXPECT_EQ(TypeOf("dot(joint.torque, joint.velocity)"), "real [N m rad/s]");
  EXPECT_EQ(TypeOf("cross(base.angular_velocity, base.position)"), "vec3 [m rad/s]");
}

TEST(Builtins, KeepTypeAndUnitOfWhatTheyLimit) {
  EXPECT_EQ(TypeOf("abs(base.velocity)"), "vec3 [m/s]");
  EXPECT_EQ(TypeOf("abs(-3)"), "int");
  EXPECT_EQ(TypeOf("min(base.position.x, 1 m)"), "real [m]");
  EXPECT_EQ(TypeOf("min(1, 2)"), "int");
  EXPECT_EQ(TypeOf("max(1, 2.5)"), "real");
  EXPECT_EQ(TypeOf("clamp(base.position.x, -1 m, 1 m)"), "real [m]");
}

TEST(Builtins, OfManyValuesAreNestedCallsOfTwo) {
  const CheckedExpression outer = CheckText("max(time, 1 s, 2 s, 3 s)");
  EXPECT_EQ(ToString(outer.unit), "s");
  const auto& call = std::get<BuiltinCall>(outer.node);
  ASSERT_EQ(call.arguments.size(), 2u);
  EXPECT_EQ(std::get<Constant>(call.arguments[1]->node).value, 3);
  const auto& middle = std::get<BuiltinCall>(call.arguments[0]->node);
  ASSERT_EQ(middle.arguments.size(), 2u);
  EXPECT_EQ(std::get<Constant>(middle.arguments[1]->node).value, 2);
}

TEST(Builtins, KnowTheirUnits) {
  EXPECT_EQ(TypeOf("sqrt(base.position.x * base.position.y)"), "real [m]");
  EXPECT_EQ(TypeOf("exp(base.up.z)"), "real");
  EXPECT_EQ(TypeOf("log(base.position.x / 1 m)"), "real");
  EXPECT_EQ(TypeOf("tanh(count(contact))"), "real");
  EXPECT_EQ(TypeOf("sin(joint.angle[left_knee_pitch])"), "real");
  EXPECT_EQ(TypeOf("cos(90 deg)"), "real");
  EXPECT_EQ(TypeOf("atan2(base.position.y, base.position.x)"), "real [rad]");
}

TEST(Builtins, TurnAnglesAndPlainNumbersIntoEachOther) {
  EXPECT_EQ(TypeOf("tan(joint.angle[left_knee_pitch])"), "real");
  EXPECT_EQ(TypeOf("asin(base.up.x)"), "real [rad]");
  EXPECT_EQ(TypeOf("acos(base.up.x)"), "real [rad]");
  EXPECT_EQ(TypeOf("atan(base.up.x)"), "real [rad]");
  EXPECT_EQ(TypeOf("wrap(2 * joint.angle[left_knee_pitch])"), "real [rad]");
  EXPECT_EQ(TypeOf("angle_between(base.velocity, base.up)"), "real [rad]");
  EXPECT_EQ(TypeOf("roll(base.orientation)"), "real [rad]");
}

TEST(Builtins, RoundPlainNumbers) {
  EXPECT_EQ(TypeOf("floor(time / 1 s)"), "real");
  EXPECT_EQ(TypeOf("round(time / 1 s)"), "real");
  EXPECT_EQ(TypeOf("pow(time / 1 s, 3)"), "real");
  EXPECT_EQ(TypeOf("sign(base.velocity)"), "vec3");
  EXPECT_EQ(TypeOf("sign(n)", "memory n: int = 0"), "int");
  EXPECT_EQ(TypeOf("tolerance(base.position.z, 0.4 m, 0.5 m, 10 cm)"), "real");
  EXPECT_EQ(TypeOf("mean(joint.torque)"), "real [N m]");
}

TEST(Builtins, MakeAndTurnVectors) {
  EXPECT_EQ(TypeOf("vec2(time, 3 s)"), "vec2 [s]");
  EXPECT_EQ(TypeOf("vec3(0, 0, 1 m)"), "vec3 [m]");
  EXPECT_EQ(TypeOf("quat(1, 0, 0, 0)"), "quat");
  EXPECT_EQ(TypeOf("normalize(base.velocity)"), "vec3");
  EXPECT_EQ(TypeOf("rotate(base.orientation, base.velocity)"), "vec3 [m/s]");
  EXPECT_EQ(TypeOf("rotate(transpose(base.rotation), base.velocity)"), "vec3 [m/s]");
  EXPECT_EQ(TypeOf("inverse(base.orientation)"), "quat");
  EXPECT_EQ(TypeOf("transpose(a)", "memory a: mat2 [m] = 0"), "mat2 [m]");
}

TEST(Builtins, ChooseBetweenValuesOfOneType) {
  EXPECT_EQ(TypeOf("select(contact[head], base.velocity, -base.velocity)"), "vec3 [m/s]");
  EXPECT_EQ(TypeOf("select(contact[head], 0, 1 m)"), "real [m]");
  EXPECT_EQ(TypeOf("select(contact[head], 1, 2)"), "int");
  EXPECT_EQ(TypeOf("select(contact[head], contact[body], true)"), "bool");
  EXPECT_EQ(TypeOf("select(contact, 1, 2)"), "int[link]");
  EXPECT_EQ(TypeOf("select(contact, 1 m, 0)"), "real[link] [m]");
  EXPECT_EQ(TypeOf("select(contact, not contact, true)"), "bool[link]");
}

// An equation that repeats its arguments must not grow without bound.
TEST(Builtins, LimitTheSizeOfWhatTheyRepeat) {
  std::string nested = "base.velocity";
  for (int i = 0; i < 12; ++i) nested = "rotate(base.orientation, " + nested + ")";
  const CheckedSource checked(TaskText("", "let tested = " + nested));
  ASSERT_EQ(checked.diagnostics.list().size(), 1u);
  EXPECT_EQ(checked.diagnostics.list()[0].code, code::kTooDeep);
}

TEST(Builtins, AreFoundByName) {
  ASSERT_NE(FindBuiltin("clamp"), nullptr);
  EXPECT_EQ(std::get<Builtin>(FindBuiltin("clamp")->function), Builtin::kClamp);
  EXPECT_EQ(FindBuiltin("Clamp"), nullptr);
  EXPECT_EQ(BuiltinNames().size(), 44u);
}

TEST(Builtins, OfSingleNumbersApplyToEachElement) {
  EXPECT_EQ(TypeOf("max(joint.angle, 0 rad)"), "real[joint] [rad]");
  EXPECT_EQ(TypeOf("max(1, joint.angle / 1 rad, 2)"), "real[joint]");
  EXPECT_EQ(TypeOf("clamp(base.velocity, 0, base.velocity)"), "vec3 [m/s]");
  EXPECT_EQ(TypeOf("sqrt(base.velocity * base.velocity)"), "vec3 [m/s]");
  EXPECT_EQ(TypeOf("sin(joint.angle)"), "real[joint]");
  EXPECT_EQ(TypeOf("wrap(joint.angle)"), "real[joint] [rad]");
  EXPECT_EQ(TypeOf("tolerance(joint.angle, 0, 1 rad, 1 rad)"), "real[joint]");
  EXPECT_EQ(TypeOf("min(joint.angle)"), "real [rad]");
  EXPECT_EQ(TypeOf("joint.angle > 1 rad"), "bool[joint]");
  EXPECT_EQ(TypeOf("base.velocity > 1 m/s"), "bool[3]");
  EXPECT_EQ(TypeOf("not contact"), "bool[link]");
  EXPECT_EQ(TypeOf("contact and contact[head]"), "bool[link]");
  EXPECT_EQ(TypeOf("base.orientation * inverse(base.orientation)"), "quat");
}

TEST(Builtins, AreDocumented) {
  const std::string page = golden::ReadFile(SOURCE_DIR "/docs/language.md");
  const size_t begin = page.find("\n### Functions\n");
  ASSERT_NE(begin, std::string::npos);
  const std::string section = page.substr(begin, page.find("\n## ", begin) - begin);
  for (const std::string& name : BuiltinNames()) {
    EXPECT_THAT(section, testing::HasSubstr("`" + name + "(")) << "docs/language.md";
  }
}

}  // namespace
}  // namespace compiler
