#include "compiler/check/sensor_use.h"

#include <taskc/plugin.h>

#include <map>

#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

std::map<std::string, uint32_t> ReadBy(const CheckedTask& task) {
  std::map<std::string, uint32_t> bits;
  for (const CheckedSensor& sensor : task.sensors) bits[sensor.name] = sensor.read_by;
  return bits;
}

constexpr uint32_t Bit(int event) { return 1u << event; }

TEST(SensorUse, IsOneBitForEachEventAndOneForTheMetrics) {
  const CheckedTask task = CheckTask(
      "task sensing for humanoid\n"
      "memory origin: real [m] = 0\n"
      "metric distance = base.position.x - origin\n"
      "on start_of_episode {\n  origin = base.position.x\n}\n"
      "on end_of_physics_step {\n  reward rate a = base.velocity.x\n}\n"
      "on end_of_time_step {\n"
      "  if time > 20 s { if contact[head] { truncate_episode \"late\" } }\n"
      "  else { reward rate b = norm(base.velocity) }\n}\n");
  EXPECT_EQ(ReadBy(task),
            (std::map<std::string, uint32_t>{
                {"base.position", Bit(TASKC_START_OF_EPISODE) | Bit(TASKC_MEASURE)},
                {"base.velocity", Bit(TASKC_END_OF_PHYSICS_STEP) | Bit(TASKC_END_OF_TIME_STEP)},
                {"time", Bit(TASKC_END_OF_TIME_STEP)},
                {"contact", Bit(TASKC_END_OF_TIME_STEP)}}));
}

TEST(SensorUse, KeepsTheOrderOfTheRobotAndItsReadsRight) {
  const CheckedTask task = CheckTask(
      TaskText("", "let a = contact[head]\nlet b = base.position.x\nlet c = a and b > 0"));
  ASSERT_EQ(task.sensors.size(), 2u);
  EXPECT_EQ(task.sensors[0].name, "base.position");
  EXPECT_EQ(task.sensors[1].name, "contact");
  const auto& body = task.events[static_cast<size_t>(EventKind::kEndOfTimeStep)].body;
  const auto& a = std::get<Elements>(std::get<CheckedLet>(body[0].node).value.node);
  EXPECT_EQ(std::get<SensorRead>(a.operand->node).sensor, 1u);
  const auto& b = std::get<Elements>(std::get<CheckedLet>(body[1].node).value.node);
  EXPECT_EQ(std::get<SensorRead>(b.operand->node).sensor, 0u);
}

TEST(SensorUse, IsNoneWhereAConstantDecides) {
  const CheckedTask task = CheckTask(TaskText("", "let a = contact[head] and false"));
  EXPECT_TRUE(task.sensors.empty());
}

}  // namespace
}  // namespace compiler
