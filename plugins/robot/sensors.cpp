#include "plugins/robot/sensors.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace robot {
namespace {

constexpr std::array<SensorDescription, static_cast<size_t>(SensorId::kCount)> kSensors = {{
    {SensorId::kTime, "time", "real", "s", "since the start of the episode"},
    {SensorId::kBasePosition, "base.position", "vec3", "m",
     "centre of the base link, in the world frame"},
    {SensorId::kBaseOrientation, "base.orientation", "quat", "",
     "orientation of the base link (w, x, y, z), from its own frame to the world frame"},
    {SensorId::kBaseRotation, "base.rotation", "mat3", "",
     "the same as a rotation matrix; its columns are base.forward, base.left and base.up"},
    {SensorId::kBaseForward, "base.forward", "vec3", "",
     "the base link's own x axis, in the world frame"},
    {SensorId::kBaseLeft, "base.left", "vec3", "",
     "the base link's own y axis, in the world frame"},
    {SensorId::kBaseUp, "base.up", "vec3", "", "the base link's own z axis, in the world frame"},
    {SensorId::kBaseVelocity, "base.velocity", "vec3", "m/s",
     "velocity of the base link's centre, in the world frame"},
    {SensorId::kBaseAngularVelocity, "base.angular_velocity", "vec3", "rad/s",
     "angular velocity of the base link, in the world frame"},
    {SensorId::kJointAngle, "joint.angle", "real[joint]", "rad",
     "angle of each hinge, from -pi to pi; 0 in the zero pose"},
    {SensorId::kJointVelocity, "joint.velocity", "real[joint]", "rad/s",
     "rate of change of each hinge's angle"},
    {SensorId::kJointTorque, "joint.torque", "real[joint]", "N m",
     "torque that the controller asked for in the last physics step, within its limit"},
    {SensorId::kContact, "contact", "bool[link]", "",
     "whether each link touches the ground, low-pass filtered: a touch shows after about 8 ms, its "
     "end after about 39 ms"},
}};

constexpr bool InOrderOfId() {
  for (size_t i = 0; i < kSensors.size(); ++i) {
    if (kSensors[i].id != static_cast<SensorId>(i)) return false;
  }
  return true;
}
static_assert(InOrderOfId());

// A joint gives way a little at its stops; see docs/simulation.md.
constexpr double kGiveOfStops = 0.1;  // [rad]

std::vector<Range> AngleRanges(const RobotDescription& robot) {
  std::vector<Range> ranges;
  for (const Joint& joint : robot.joints) {
    ranges.push_back({std::max(joint.low - kGiveOfStops, -std::numbers::pi),
                      std::min(joint.high + kGiveOfStops, std::numbers::pi)});
  }
  return ranges;
}

// One range for each element, or one for all.
std::vector<Range> CommonRanges(const SensorDescription& sensor, const RobotDescription& robot) {
  switch (sensor.id) {
    case SensorId::kTime:
      return {{.low = 0}};
    case SensorId::kBaseOrientation:
    case SensorId::kBaseRotation:
    case SensorId::kBaseForward:
    case SensorId::kBaseLeft:
    case SensorId::kBaseUp:
      return {{-1, 1}};
    case SensorId::kJointAngle:
      return AngleRanges(robot);
    case SensorId::kJointTorque:
      return {{-robot.controller.max_torque, robot.controller.max_torque}};
    case SensorId::kContact:
      return {{0, 1}};
    default:
      break;
  }
  for (const NominalRange& nominal : robot.nominal_ranges) {
    if (nominal.sensor == sensor.name) return nominal.elements;
  }
  return {Range{}};
}

}  // namespace

std::span<const SensorDescription> Sensors() { return kSensors; }

int ElementCount(const SensorDescription& sensor, const RobotDescription& robot) {
  if (sensor.type.ends_with("[joint]")) return static_cast<int>(robot.joints.size());
  if (sensor.type.ends_with("[link]")) return static_cast<int>(robot.links.size());
  if (sensor.type == "vec3") return 3;
  if (sensor.type == "quat") return 4;
  if (sensor.type == "mat3") return 9;
  return 1;
}

std::vector<Range> RangesOf(const SensorDescription& sensor, const RobotDescription& robot) {
  std::vector<Range> ranges = CommonRanges(sensor, robot);
  const auto count = static_cast<size_t>(ElementCount(sensor, robot));
  if (ranges.size() == 1) ranges.resize(count, ranges.front());
  return ranges;
}

}  // namespace robot
