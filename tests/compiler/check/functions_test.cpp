// Functions, their calls, and the tests of a task.
#include "compiler/check/functions.h"

#include <cmath>

#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

const std::string kEvent = "on end_of_time_step {\n";

TEST(Functions, StandBehindThoseThatTheyCall) {
  const CheckedTask task = CheckTask(
      "task calling for humanoid\n"
      "fn third(x: real) -> real = second(x) + first(x)\nfn unused() -> real = third(1)\n"
      "fn second(x: real) -> real = first(x)\nfn first(x: real) -> real = x\n" +
      kEvent + "  reward rate a = third(2)\n}\n");
  ASSERT_EQ(task.functions.size(), 3u);
  EXPECT_EQ(task.functions[0].name, "first");
  EXPECT_EQ(task.functions[1].name, "second");
  EXPECT_EQ(task.functions[2].name, "third");
  const auto& body = task.events[static_cast<size_t>(EventKind::kEndOfTimeStep)].body;
  EXPECT_EQ(std::get<FunctionCall>(std::get<CheckedReward>(body.at(0).node).value.node).function,
            2u);
  const auto& sum = std::get<CheckedBinary>(task.functions[2].value.node);
  EXPECT_EQ(std::get<FunctionCall>(sum.left->node).function, 1u);
  EXPECT_EQ(std::get<FunctionCall>(sum.right->node).function, 0u);
}

TEST(Functions, ConvertArgumentsAndResults) {
  EXPECT_EQ(TypeOf("scaled(2, 0)", "fn scaled(x: real, y: real [m]) -> real [m] = 0"), "real [m]");
  const CheckedExpression call =
      CheckText("scaled(2, 0)", "fn scaled(x: real, y: real [m]) -> real [m] = x * y");
  const auto& arguments = std::get<FunctionCall>(call.node).arguments;
  EXPECT_EQ(ToString(arguments.at(0)->type), "real");
  EXPECT_EQ(ToString(arguments.at(1)->unit), "m");
}

TEST(Functions, HaveNamesOfTheirOwnInside) {
  const CheckedTask task = CheckTask(
      "task calling for humanoid\nparam gain: real = 1\n"
      "fn scaled(gain: real, time: real) -> real {\n  let base = gain\n  return base * time\n}\n" +
      kEvent + "  reward rate a = scaled(gain, time / 1 s)\n}\n");
  EXPECT_EQ(task.functions.at(0).arguments.size(), 2u);
  EXPECT_EQ(task.functions[0].locals.at(0).name, "base");
}

TEST(Functions, TakeTheUnitThatEachCallSays) {
  const std::string ratio = "fn ratio(x: real [unit], y: real [unit]) -> real = x / y";
  EXPECT_EQ(TypeOf("ratio(2 m, 3 m)", ratio), "real");
  EXPECT_EQ(TypeOf("ratio(0, 3 s)", ratio), "real");
  EXPECT_EQ(CheckText("ratio(0, 3 s)", ratio).unit, Unit{});
  const std::string speed =
      "fn speed(way: vec3 [unit], t: real [s], squared: real [unit^2]) -> real [unit/s] =\n"
      "    norm(way) / t + sqrt(squared) / t";
  EXPECT_EQ(TypeOf("speed(base.position, 1 s, 4 m^2)", speed), "real [m/s]");
  EXPECT_EQ(TypeOf("speed(base.angular_velocity, 1 s, 0)", speed), "real [rad/s^2]");
  // One that leaves it open may call another one.
  EXPECT_EQ(TypeOf("twice(1 N)",
                   "fn twice(x: real [unit]) -> real [unit] = once(x) + once(x)\n"
                   "fn once(x: real [unit]) -> real [unit] = x"),
            "real [N]");
}

TEST(Functions, OfSingleValuesApplyToEachElement) {
  const std::string shaped =
      "fn shaped(x: real [unit], y: real [unit], up: bool) -> real [unit] =\n"
      "    select(up, x, y)";
  EXPECT_EQ(TypeOf("shaped(joint.angle, 0, true)", shaped), "real[joint] [rad]");
  EXPECT_EQ(TypeOf("shaped(1 m, base.position, true)", shaped), "vec3 [m]");
  EXPECT_EQ(TypeOf("shaped(link.position[feet].z, 1 m, contact[feet])", shaped), "real[2] [m]");
  EXPECT_TRUE(
      std::get<FunctionCall>(CheckText("shaped(1 m, base.position, true)", shaped).node).is_each);
  const std::string high = "fn high(x: real [unit], n: int) -> bool = n > 2";
  EXPECT_EQ(TypeOf("high(base.position, 1)", high), "bool[3]");
  EXPECT_EQ(TypeOf("high(joint.angle, 1)", high), "bool[joint]");
}

TEST(Tests, KnowTheSensorsThatAreKept) {
  const CheckedTask task = CheckTask(
      TaskText(
          "",
          "if contact[head] { reward fall = -1 }\nif time > 1 s { truncate_episode \"late\" }") +
      "test \"a fall\" {\n  given contact[head] = true\n  fire start_of_action, 3 * "
      "end_of_time_step\n"
      "  expect contact[head] and total(fall) == -3\n  expect truncate_episode \"late\"\n}\n");
  ASSERT_EQ(task.tests.size(), 1u);
  const auto& statements = task.tests[0].statements;
  ASSERT_EQ(statements.size(), 5u);
  const auto& given = std::get<CheckedGiven>(statements[0].node);
  EXPECT_EQ(task.sensors.at(given.index).name, "contact");
  EXPECT_EQ(given.elements, (std::vector<uint32_t>{1}));
  EXPECT_EQ(std::get<CheckedFire>(statements[2].node).times, 3u);
  const auto& both =
      std::get<CheckedBinary>(std::get<CheckedExpect>(statements[3].node).condition.node);
  const auto& contact = std::get<Elements>(both.left->node);
  EXPECT_EQ(std::get<SensorRead>(contact.operand->node).sensor, given.index);
  EXPECT_EQ(std::get<CheckedExpectEnd>(statements[4].node).reason, "late");
}

TEST(Sensors, HaveARangeForEachElement) {
  const CheckedTask task = CheckTask(
      "task bare\nsensor force: real[2] [N] in -1 N .. 2 N\nsensor time: real [s]\n" + kEvent +
      "  reward rate a = sum(force)\n  if time > 1 s { truncate_episode \"late\" }\n}\n");
  EXPECT_EQ(task.sensors.at(0).minimum, (std::vector<double>{-1, -1}));
  EXPECT_EQ(task.sensors[0].maximum, (std::vector<double>{2, 2}));
  EXPECT_EQ(task.sensors.at(1).minimum.size(), 1u);
  EXPECT_TRUE(std::isinf(task.sensors[1].maximum[0]));
}

}  // namespace
}  // namespace compiler
