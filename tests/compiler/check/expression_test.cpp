// Types and units of expressions, against what a reader works out by hand.
#include <numbers>

#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

double ConstantOf(const std::string& expression) {
  const CheckedExpression checked = CheckText(expression);
  const auto* constant = std::get_if<Constant>(&checked.node);
  EXPECT_NE(constant, nullptr) << expression << " is no constant";
  return constant != nullptr ? constant->value : 0;
}

TEST(Expression, LiteralsHaveTypeUnitAndSiValue) {
  EXPECT_EQ(TypeOf("3"), "int");
  EXPECT_EQ(TypeOf("3.0"), "real");
  EXPECT_EQ(TypeOf("3e2"), "real");
  EXPECT_EQ(TypeOf("true"), "bool");
  EXPECT_EQ(TypeOf("20 s"), "real [s]");
  EXPECT_EQ(TypeOf("5 N*m"), "real [N m]");
  EXPECT_EQ(TypeOf("4 / s"), "real [1/s]");
  EXPECT_EQ(ConstantOf("5 ms"), 0.005);
  EXPECT_DOUBLE_EQ(ConstantOf("30 deg"), std::numbers::pi / 6);
  EXPECT_EQ(TypeOf("pi"), "real");
  EXPECT_EQ(ConstantOf("pi"), std::numbers::pi);
}

TEST(Expression, SensorsAreTakenByTheirLongestName) {
  EXPECT_EQ(TypeOf("base.velocity"), "vec3 [m/s]");
  EXPECT_EQ(TypeOf("base.velocity.xy"), "vec2 [m/s]");
  EXPECT_EQ(TypeOf("base.angular_velocity.z"), "real [rad/s]");
  EXPECT_EQ(TypeOf("joint.torque"), "real[joint] [N m]");
  EXPECT_EQ(TypeOf("contact"), "bool[link]");
  EXPECT_EQ(TypeOf("time"), "real [s]");
  EXPECT_EQ(TypeOf("base.orientation"), "quat");
  EXPECT_EQ(TypeOf("base.rotation"), "mat3");
}

TEST(Expression, ParamsAndMemoryHaveTheirDeclaredTypes) {
  EXPECT_EQ(TypeOf("gain", "param gain: real [1/s] = 4 / s"), "real [1/s]");
  EXPECT_EQ(TypeOf("steps", "memory steps: int = 0"), "int");
  EXPECT_EQ(TypeOf("touched", "memory touched: bool[link] = false"), "bool[link]");
  EXPECT_EQ(TypeOf("way.xy", "memory way: vec3 [m] = 0 m"), "vec2 [m]");
  EXPECT_EQ(TypeOf("samples", "memory samples: real[4] = 0"), "real[4]");
}

TEST(Expression, EventsKnowTheirRewardAndTimeStep) {
  EXPECT_EQ(TypeOf("reward"), "real");
  EXPECT_EQ(TypeOf("time_step"), "real [s]");
}

TEST(Expression, ProductsMultiplyUnits) {
  EXPECT_EQ(TypeOf("base.velocity.x * time"), "real [m]");
  EXPECT_EQ(TypeOf("base.velocity / time"), "vec3 [m/s^2]");
  EXPECT_EQ(TypeOf("2 * base.velocity"), "vec3 [m/s]");
  EXPECT_EQ(TypeOf("1 / base.position"), "vec3 [1/m]");
  EXPECT_EQ(TypeOf("joint.torque * joint.velocity"), "real[joint] [N m rad/s]");
  EXPECT_EQ(TypeOf("base.rotation * 2"), "mat3");
  EXPECT_EQ(TypeOf("0.25 / 5 ms * dot(base.velocity.xy, base.up.xy)"), "real [m/s^2]");
}

TEST(Expression, SumsKeepTheirUnit) {
  EXPECT_EQ(TypeOf("base.position + base.velocity * 1 s"), "vec3 [m]");
  EXPECT_EQ(TypeOf("base.position - 5 cm"), "vec3 [m]");
  EXPECT_EQ(TypeOf("-base.position"), "vec3 [m]");
  EXPECT_EQ(TypeOf("base.rotation - base.rotation"), "mat3");
}

TEST(Expression, LiteralZeroFitsEveryUnit) {
  EXPECT_EQ(TypeOf("base.position.x > 0"), "bool");
  EXPECT_EQ(TypeOf("0.0 < base.velocity.x"), "bool");
  EXPECT_EQ(TypeOf("base.position.x + 0"), "real [m]");
  EXPECT_EQ(TypeOf("max(0, base.velocity.x)"), "real [m/s]");
  EXPECT_EQ(TypeOf("clamp(base.position.z, 0, 1 m)"), "real [m]");
  EXPECT_EQ(TypeOf("sin(0)"), "real");
}

TEST(Expression, OnlyIntsStayInts) {
  EXPECT_EQ(TypeOf("2 + 3"), "int");
  EXPECT_EQ(TypeOf("2 + 3.0"), "real");
  EXPECT_EQ(TypeOf("1 / 2"), "real");
  EXPECT_EQ(ConstantOf("1 / 2"), 0.5);
  EXPECT_EQ(TypeOf("count(contact)"), "int");
  EXPECT_EQ(TypeOf("count(contact) * 2"), "int");
  EXPECT_EQ(TypeOf("count(contact) * 0.5"), "real");
}

TEST(Expression, IntsAreConvertedWhereARealIsWanted) {
  const CheckedExpression sum = CheckText("count(contact) + 0.5");
  const auto& binary = std::get<CheckedBinary>(sum.node);
  EXPECT_TRUE(std::holds_alternative<IntToReal>(binary.left->node));
  EXPECT_EQ(binary.left->type.scalar, Scalar::kReal);
}

TEST(Expression, IntLiteralsBecomeRealConstants) {
  const CheckedExpression product = CheckText("base.position.x * 2");
  const auto& binary = std::get<CheckedBinary>(product.node);
  EXPECT_EQ(std::get<Constant>(binary.right->node).value, 2);
  EXPECT_EQ(binary.right->type.scalar, Scalar::kReal);
}

TEST(Expression, ComparisonsAndLogicGiveBools) {
  EXPECT_EQ(TypeOf("time >= 2 s and not contact[head]"), "bool");
  EXPECT_EQ(TypeOf("contact[head] == contact[body]"), "bool");
  EXPECT_EQ(TypeOf("contact[head] != true"), "bool");
  EXPECT_EQ(TypeOf("count(contact) == 2"), "bool");
  EXPECT_EQ(TypeOf("count(contact) < 2.5"), "bool");
}

TEST(Expression, SpansTheWholeText) {
  const CheckedSource checked(TaskText("", "let tested = (time + 1 s)"));
  ASSERT_TRUE(checked.task);
  const auto& body = checked.task->events[static_cast<size_t>(EventKind::kEndOfTimeStep)].body;
  const Span span = std::get<CheckedLet>(body[0].node).value.span;
  const std::string text(checked.sources.main().TextOf(span));
  EXPECT_NE(text.find("time + 1 s"), std::string::npos) << text;
}

}  // namespace
}  // namespace compiler
