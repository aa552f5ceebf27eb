// The sensors that every robot described by a file offers to its tasks: the one list from which the
// compiler knows names, types and units, and the environment knows what to compute.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "plugins/robot/robot_description.h"

namespace robot {

enum class SensorId {
  kTime,
  kBasePosition,
  kBaseOrientation,
  kBaseRotation,
  kBaseForward,
  kBaseLeft,
  kBaseUp,
  kBaseVelocity,
  kBaseAngularVelocity,
  kBaseAcceleration,
  kJointAngle,
  kJointVelocity,
  kJointAcceleration,
  kJointTorque,
  kJointTarget,
  kLinkPosition,
  kLinkOrientation,
  kLinkVelocity,
  kLinkAngularVelocity,
  kContact,
  kContactForce,
  kSitePosition,
  kSiteOrientation,
  kSiteVelocity,
  kSiteAngularVelocity,
  kSiteAcceleration,
  kCount
};

struct SensorDescription {
  SensorId id;
  std::string_view name;  // "base.velocity"
  std::string_view type;  // in the task language: "vec3", "real[joint]", "vec3[link]"
  std::string_view unit;  // "m/s"; "" for a plain number
  std::string_view doc;   // with its frame
  // The elements, or those of each entry of an array, while the robot stands upright and still, its
  // axes along the world's; empty: all 0 or false.
  std::span<const double> at_rest;
  // A real robot knows it by what it carries itself: encoders, an inertial unit that tells how it
  // is turned, touch switches, a clock, and what its controller is told.
  bool is_onboard = true;
};

// In the order of SensorId.
std::span<const SensorDescription> Sensors();
// Those that this robot has, in the same order: all, but those of sites only where there are some.
std::span<const SensorDescription> SensorsOf(const RobotDescription& robot);

// The sensor called `name`, or null.
const SensorDescription* FindSensor(std::string_view name);

// The number of elements that a sensor of this type has for this robot: 3 for "vec3", 9 for "mat3",
// the number of links for "bool[link]", three times that for "vec3[link]".
int ElementCount(const SensorDescription& sensor, const RobotDescription& robot);
// How many entries an array over "link", "joint" or "site" has; nothing of another index.
std::optional<size_t> EntryCount(std::string_view index, const RobotDescription& robot);

// The values that each element of the sensor can have for this robot: from what the sensor is, the
// joints' stops, the controller's limit, what the description says of the rest, and what follows
// from that.
std::vector<Range> RangesOf(const SensorDescription& sensor, const RobotDescription& robot);
// Whether nothing bounds the sensor by itself, so that a description may give its range.
bool IsUnlimited(SensorId sensor);

// What tasks read like sensors, and what is known of a robot before any run.
struct ConstantDescription {
  std::string_view name;  // "joint.low"
  std::string_view type;
  std::string_view unit;
  std::string_view doc;
};
std::span<const ConstantDescription> Constants();
// One value for each element.
std::vector<double> ValuesOf(const ConstantDescription& constant, const RobotDescription& robot);

}  // namespace robot
