// What robots are said to sense is what they sense.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "plugins/robot/sensors.h"
#include "runtime/training/simulation/robot_sensors.h"
#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

void ExpectInside(RobotSensor& sensor, const robot::RobotDescription& robot) {
  const std::vector<robot::Range> ranges = robot::RangesOf(sensor.description(), robot);
  if (sensor.description().type.starts_with("bool")) return;
  const double* values = sensor.Read().reals();
  for (size_t i = 0; i < ranges.size(); ++i) {
    EXPECT_GE(values[i], ranges[i].low) << sensor.description().name << " " << i;
    EXPECT_LE(values[i], ranges[i].high) << sensor.description().name << " " << i;
  }
}

// New targets ten times a second, anywhere between the stops but no further than `largest`.
void MoveAtRandom(const char* profile, double largest, double seconds) {
  const robot::RobotDescription& robot = Humanoid();
  std::mt19937 random(7);
  for (const robot::Pose& pose : robot.poses) {
    World world(robot, FindProfile(profile), pose);
    RobotSensors sensors(robot, nullptr);
    std::vector<double> targets = Zeros(robot);
    for (double time = 0; time < seconds; time += 0.005) {
      if (random() % 20 == 0) {
        for (size_t j = 0; j < targets.size(); ++j) {
          targets[j] = std::uniform_real_distribution<double>(
              std::max(robot.joints[j].low, -largest),
              std::min(robot.joints[j].high, largest))(random);
        }
      }
      world.StartTimeStep(
          {.base_acceleration = true, .joint_accelerations = true, .contact_forces = true});
      StepFor(world, 0.005, targets);
      sensors.Refresh(world, time);
      for (RobotSensor& sensor : sensors.sensors()) ExpectInside(sensor, robot);
    }
  }
}

TEST(SensorRanges, HoldWhateverTheRobotDoesInThePapersProfile) { MoveAtRandom("paper", 3.2, 0.5); }

// In the fast profile a robot whose limbs are driven into each other can be thrown about.
TEST(SensorRanges, HoldInModestMotionsInTheFastProfile) { MoveAtRandom("fast", 0.8, 3); }

}  // namespace
}  // namespace runtime
