#include "plugins/robot/sensors.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numbers>

namespace robot {
namespace {

constexpr std::span<const double> kZeros;
constexpr double kX[] = {1, 0, 0};
constexpr double kY[] = {0, 1, 0};
constexpr double kZ[] = {0, 0, 1};
constexpr double kNoTurn[] = {1, 0, 0, 0};
constexpr double kIdentity[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

constexpr std::array<SensorDescription, static_cast<size_t>(SensorId::kCount)> kSensors = {{
    {SensorId::kTime, "time", "real", "s", "since the start of the episode", kZeros},
    {SensorId::kBasePosition, "base.position", "vec3", "m",
     "center of the base link, in the world frame", kZeros},
    {SensorId::kBaseOrientation, "base.orientation", "quat", "",
     "orientation of the base link (w, x, y, z), from its own frame to the world frame", kNoTurn},
    {SensorId::kBaseRotation, "base.rotation", "mat3", "",
     "the same as a rotation matrix; its columns are base.forward, base.left and base.up",
     kIdentity},
    {SensorId::kBaseForward, "base.forward", "vec3", "",
     "the base link's own x axis, in the world frame", kX},
    {SensorId::kBaseLeft, "base.left", "vec3", "", "the base link's own y axis, in the world frame",
     kY},
    {SensorId::kBaseUp, "base.up", "vec3", "", "the base link's own z axis, in the world frame",
     kZ},
    {SensorId::kBaseVelocity, "base.velocity", "vec3", "m/s",
     "velocity of the base link's center, in the world frame", kZeros},
    {SensorId::kBaseAngularVelocity, "base.angular_velocity", "vec3", "rad/s",
     "angular velocity of the base link, in the world frame", kZeros},
    {SensorId::kJointAngle, "joint.angle", "real[joint]", "rad",
     "angle of each hinge, from -pi to pi; 0 in the zero pose", kZeros},
    {SensorId::kJointVelocity, "joint.velocity", "real[joint]", "rad/s",
     "rate of change of each hinge's angle", kZeros},
    {SensorId::kJointTorque, "joint.torque", "real[joint]", "N m",
     "torque that the controller asked for in the last physics step, within its limit", kZeros},
    {SensorId::kContact, "contact", "bool[link]", "",
     "whether each link touches the ground, low-pass filtered: a touch shows after about 8 ms, its "
     "end after about 39 ms",
     kZeros},
}};

constexpr bool InOrderOfId() {
  for (size_t i = 0; i < kSensors.size(); ++i) {
    if (kSensors[i].id != static_cast<SensorId>(i)) return false;
  }
  return true;
}
static_assert(InOrderOfId());

// Of the types that do not depend on the robot; 0 of those that do.
constexpr int CountOf(std::string_view type) {
  if (type == "bool" || type == "int" || type == "real") return 1;
  if (type == "vec2") return 2;
  if (type == "vec3") return 3;
  if (type == "vec4" || type == "quat") return 4;
  if (type == "mat3") return 9;
  return 0;
}

constexpr bool HaveCountedTypes() {
  for (const SensorDescription& sensor : kSensors) {
    const bool is_of_robot = sensor.type.ends_with("[joint]") || sensor.type.ends_with("[link]");
    const auto count = static_cast<size_t>(CountOf(sensor.type));
    if (is_of_robot ? !sensor.at_rest.empty() : count == 0) return false;
    if (!sensor.at_rest.empty() && sensor.at_rest.size() != count) return false;
  }
  return true;
}
static_assert(HaveCountedTypes());

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

// What no stop, limit or length bounds: as the robot's description says.
std::vector<Range> NominalRanges(const SensorDescription& sensor, const RobotDescription& robot) {
  for (const NominalRange& nominal : robot.nominal_ranges) {
    if (nominal.sensor == sensor.name) return nominal.elements;
  }
  return {Range{}};
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
    case SensorId::kBasePosition:
    case SensorId::kBaseVelocity:
    case SensorId::kBaseAngularVelocity:
    case SensorId::kJointVelocity:
      return NominalRanges(sensor, robot);
    case SensorId::kCount:
      break;
  }
  std::abort();
}
}  // namespace

std::span<const SensorDescription> Sensors() { return kSensors; }

const SensorDescription* FindSensor(std::string_view name) {
  const auto found = std::ranges::find(kSensors, name, &SensorDescription::name);
  return found == kSensors.end() ? nullptr : &*found;
}

int ElementCount(const SensorDescription& sensor, const RobotDescription& robot) {
  if (sensor.type.ends_with("[joint]")) return static_cast<int>(robot.joints.size());
  if (sensor.type.ends_with("[link]")) return static_cast<int>(robot.links.size());
  return CountOf(sensor.type);
}

std::vector<Range> RangesOf(const SensorDescription& sensor, const RobotDescription& robot) {
  std::vector<Range> ranges = CommonRanges(sensor, robot);
  const auto count = static_cast<size_t>(ElementCount(sensor, robot));
  if (ranges.size() == 1) ranges.resize(count, ranges.front());
  return ranges;
}

}  // namespace robot
