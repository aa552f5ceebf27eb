#include "plugins/robot/sensors.h"

#include <algorithm>
#include <array>

namespace robot {
namespace {

constexpr std::span<const double> kZeros;
constexpr double kX[] = {1, 0, 0};
constexpr double kY[] = {0, 1, 0};
constexpr double kZ[] = {0, 0, 1};
constexpr double kNoTurn[] = {1, 0, 0, 0};
constexpr double kIdentity[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
constexpr double kHeld[] = {0, 0, kGravity};
constexpr bool kNotOnboard = false;

constexpr std::array<SensorDescription, static_cast<size_t>(SensorId::kCount)> kSensors = {{
    {SensorId::kTime, "time", "real", "s", "since the start of the episode", kZeros},
    {SensorId::kBasePosition, "base.position", "vec3", "m",
     "center of the base link, in the world frame", kZeros, kNotOnboard},
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
     "velocity of the base link's center, in the world frame", kZeros, kNotOnboard},
    {SensorId::kBaseAngularVelocity, "base.angular_velocity", "vec3", "rad/s",
     "angular velocity of the base link, in the world frame", kZeros},
    {SensorId::kBaseAcceleration, "base.acceleration", "vec3", "m/s^2",
     "what an accelerometer in the base link's center shows, along the link's own axes: its mean "
     "acceleration since the start of the last time step, less that of gravity",
     kHeld},
    {SensorId::kJointAngle, "joint.angle", "real[joint]", "rad",
     "angle of each joint; 0 in the zero pose", kZeros},
    {SensorId::kJointVelocity, "joint.velocity", "real[joint]", "rad/s",
     "rate of change of each joint's angle", kZeros},
    {SensorId::kJointAcceleration, "joint.acceleration", "real[joint]", "rad/s^2",
     "mean rate of change of each joint's velocity since the start of the last time step", kZeros},
    {SensorId::kJointTorque, "joint.torque", "real[joint]", "N m",
     "torque that the controller asked for in the last physics step, within its limit", kZeros},
    {SensorId::kJointTarget, "joint.target", "real[joint]", "rad",
     "angle that the controller was told to bring each joint to in the last physics step", kZeros},
    {SensorId::kLinkPosition, "link.position", "vec3[link]", "m",
     "center of mass of each link, in the world frame", kZeros, kNotOnboard},
    {SensorId::kLinkOrientation, "link.orientation", "quat[link]", "",
     "orientation of each link (w, x, y, z), from its own frame to the world frame", kNoTurn},
    {SensorId::kLinkVelocity, "link.velocity", "vec3[link]", "m/s",
     "velocity of each link's center of mass, in the world frame", kZeros, kNotOnboard},
    {SensorId::kLinkAngularVelocity, "link.angular_velocity", "vec3[link]", "rad/s",
     "angular velocity of each link, in the world frame", kZeros},
    {SensorId::kContact, "contact", "bool[link]", "",
     "whether each link touches the ground, low-pass filtered: a touch shows after about 8 ms, its "
     "end after about 39 ms",
     kZeros},
    {SensorId::kContactForce, "contact_force", "vec3[link]", "N",
     "sum of the forces of all contacts on each link, with the ground and with other links, in the "
     "world frame: their mean since the start of the last time step",
     kZeros, kNotOnboard},
    {SensorId::kSitePosition, "site.position", "vec3[site]", "m",
     "place of each site, in the world frame", kZeros, kNotOnboard},
    {SensorId::kSiteOrientation, "site.orientation", "quat[site]", "",
     "orientation of each site (w, x, y, z), from its own frame to the world frame", kNoTurn},
    {SensorId::kSiteVelocity, "site.velocity", "vec3[site]", "m/s",
     "velocity of each site, in the world frame", kZeros, kNotOnboard},
    {SensorId::kSiteAngularVelocity, "site.angular_velocity", "vec3[site]", "rad/s",
     "angular velocity of each site, in the world frame", kZeros},
    {SensorId::kSiteAcceleration, "site.acceleration", "vec3[site]", "m/s^2",
     "what an accelerometer at each site shows, along the site's own axes: its mean acceleration "
     "since the start of the last time step, less that of gravity",
     kHeld},
}};

constexpr bool InOrderOfId() {
  for (size_t i = 0; i < kSensors.size(); ++i) {
    if (kSensors[i].id != static_cast<SensorId>(i)) return false;
  }
  return true;
}
static_assert(InOrderOfId());

constexpr size_t kSiteSensors =
    static_cast<size_t>(SensorId::kCount) - static_cast<size_t>(SensorId::kSitePosition);

constexpr bool IsOfSites(const SensorDescription& sensor) {
  return sensor.type.ends_with("[site]");
}

// SensorsOf() leaves out the end of the list.
constexpr bool HaveSitesLast() {
  return std::ranges::all_of(std::span(kSensors).last(kSiteSensors), IsOfSites) &&
         std::ranges::none_of(std::span(kSensors).first(kSensors.size() - kSiteSensors), IsOfSites);
}
static_assert(HaveSitesLast());

// What an array has for each link, joint or site; of other types all.
constexpr std::string_view EntryOf(std::string_view type) { return type.substr(0, type.find('[')); }

// 0 of unknown types.
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
    const auto count = static_cast<size_t>(CountOf(EntryOf(sensor.type)));
    if (count == 0) return false;
    if (!sensor.at_rest.empty() && sensor.at_rest.size() != count) return false;
  }
  return true;
}
static_assert(HaveCountedTypes());

constexpr std::array kConstants = {
    ConstantDescription{"joint.low", "real[joint]", "rad", "the lower stop of each joint"},
    ConstantDescription{"joint.high", "real[joint]", "rad", "the upper stop of each joint"},
    ConstantDescription{"joint.rest", "real[joint]", "rad",
                        "the angle of each joint in the robot's first pose"},
    ConstantDescription{"joint.max_torque", "real[joint]", "N m",
                        "the most that the controller exerts on each joint"},
    ConstantDescription{"link.mass", "real[link]", "kg", "the mass of each link"},
};

}  // namespace

std::span<const SensorDescription> Sensors() { return kSensors; }

const SensorDescription* FindSensor(std::string_view name) {
  const auto found = std::ranges::find(kSensors, name, &SensorDescription::name);
  return found == kSensors.end() ? nullptr : &*found;
}

std::span<const SensorDescription> SensorsOf(const RobotDescription& robot) {
  return Sensors().first(kSensors.size() - (robot.sites.empty() ? kSiteSensors : 0));
}

int ElementCount(const SensorDescription& sensor, const RobotDescription& robot) {
  const std::string_view type = sensor.type;
  const size_t bracket = type.find('[');
  const int count = CountOf(EntryOf(type));
  if (bracket == std::string_view::npos) return count;
  const std::string_view index = type.substr(bracket + 1, type.size() - bracket - 2);
  return count * static_cast<int>(*EntryCount(index, robot));
}

std::optional<size_t> EntryCount(std::string_view index, const RobotDescription& robot) {
  if (index == "link") return robot.links.size();
  if (index == "joint") return robot.joints.size();
  if (index == "site") return robot.sites.size();
  return std::nullopt;
}

std::span<const ConstantDescription> Constants() { return kConstants; }

std::vector<double> ValuesOf(const ConstantDescription& constant, const RobotDescription& robot) {
  std::vector<double> values;
  if (constant.name == "joint.low") {
    for (const Joint& joint : robot.joints) values.push_back(joint.low);
  } else if (constant.name == "joint.high") {
    for (const Joint& joint : robot.joints) values.push_back(joint.high);
  } else if (constant.name == "joint.rest") {
    values = robot.poses.front().joint_angles;
  } else if (constant.name == "joint.max_torque") {
    for (const Joint& joint : robot.joints) values.push_back(robot.GainsOf(joint).max_torque);
  } else {
    for (const Link& link : robot.links) values.push_back(link.mass);
  }
  return values;
}

}  // namespace robot
