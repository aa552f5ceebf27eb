#include <array>
#include <cmath>
#include <numbers>

#include "plugins/robot/read_parts.h"

namespace robot {
namespace {

// "z", or a direction as three numbers.
Vector3 ReadAxis(const TomlValue& value) {
  if (value.IsText()) {
    Vector3 axis{};
    axis[value.IndexIn({"x", "y", "z"}, "axis")] = 1;
    return axis;
  }
  Vector3 axis = value.ToVector3();
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  if (length < 1e-6) value.Fail(value.what() + " has no direction", "give \"x\", \"y\" or \"z\"");
  for (double& component : axis) component /= length;
  return axis;
}

// The two, in the unit of the file.
std::vector<double> ReadStops(const TomlValue& value) {
  std::vector<double> stops = value.Numbers(2);
  if (stops[0] >= stops[1]) {
    value.Fail(value.what() + ": the low stop is not below the high stop", "write [low, high]");
  }
  return stops;
}

OwnGains ReadGains(const TomlValue& value) {
  const auto positive = [&](std::string_view key) {
    const auto found = value.Find(key);
    return found ? std::optional(found->PositiveNumber()) : std::nullopt;
  };
  const OwnGains gains = {.stiffness = positive("stiffness"),
                          .damping = positive("damping"),
                          .max_torque = positive("max_torque"),
                          .max_speed = positive("max_speed")};
  const auto passive = value.Find("passive");
  if (!passive || !passive->Flag()) return gains;
  for (const std::string_view key : {"stiffness", "damping", "max_torque", "max_speed"}) {
    if (const auto own = value.Find(key))
      own->Fail(own->what() + " is of a motor, and a passive joint has none",
                "leave out `passive`, or this");
  }
  return {.stiffness = 0, .damping = 0, .max_torque = 0, .max_speed = {}};
}

PassiveForces ReadPassiveForces(const TomlValue& value) {
  const auto read = [&](std::string_view key) {
    const auto found = value.Find(key);
    return found ? found->NumberNotBelowZero() : 0;
  };
  const auto rest = value.Find("spring_rest");
  return {.spring = read("spring"),
          .spring_rest = rest ? rest->Number() : 0,
          .damper = read("damper"),
          .friction = read("friction"),
          .armature = read("armature")};
}

// Each reads what is special in one type of joint.

void ReadHinge(const TomlValue& value, Joint& joint) {
  joint.anchor = value.At("anchor").ToVector3();
  const std::vector<double> stops = ReadStops(value.At("stops_deg"));
  joint.low = stops[0] * std::numbers::pi / 180;
  joint.high = stops[1] * std::numbers::pi / 180;
}

void ReadContinuous(const TomlValue& value, Joint& joint) {
  joint.anchor = value.At("anchor").ToVector3();
  joint.low = -kUnlimited;
  joint.high = kUnlimited;
}

void ReadSlider(const TomlValue& value, Joint& joint) {
  if (const auto radius = value.Find("radius")) joint.radius = radius->PositiveNumber();
  const std::vector<double> stops = ReadStops(value.At("travel"));
  joint.low = stops[0] / joint.radius;
  joint.high = stops[1] / joint.radius;
}

void ReadFixed(const TomlValue&, Mount&) {}

void ReadBall(const TomlValue& value, Mount& mount) {
  mount.anchor = value.At("anchor").ToVector3();
  if (const auto damper = value.Find("damper")) mount.damper = damper->NumberNotBelowZero();
}

struct JointType {
  const char* name;
  JointKind kind;
  void (*read)(const TomlValue&, Joint&);
};
constexpr std::array kJointTypes = {
    JointType{"hinge", JointKind::kHinge, ReadHinge},
    JointType{"continuous", JointKind::kContinuous, ReadContinuous},
    JointType{"slider", JointKind::kSlider, ReadSlider},
};

struct MountType {
  const char* name;
  MountKind kind;
  void (*read)(const TomlValue&, Mount&);
};
constexpr std::array kMountTypes = {
    MountType{"fixed", MountKind::kFixed, ReadFixed},
    MountType{"ball", MountKind::kBall, ReadBall},
};

// The index of its type: those of joints, then those of mounts.
size_t TypeOf(const TomlValue& value) {
  const auto type = value.Find("type");
  if (!type) return 0;
  std::vector<std::string> names;
  for (const JointType& each : kJointTypes) names.emplace_back(each.name);
  for (const MountType& each : kMountTypes) names.emplace_back(each.name);
  return static_cast<size_t>(type->IndexIn(names, "type of joint"));
}

// Joints are listed from the base outwards, each link below exactly one joint: then they form a
// tree, and a single pass over them in order reaches every link after its parent.
void CheckPlaceInTree(const TomlValue& value, int parent, int child, std::vector<bool>& attached,
                      const RobotDescription& robot) {
  const std::string& parent_name = robot.links[parent].name;
  const std::string& child_name = robot.links[child].name;
  if (child == 0) {
    value.Fail(fmt::format("{} hangs the base link `{}` on another link", value.what(), child_name),
               "swap `parent` and `child`, or list another link first");
  }
  if (attached[child]) {
    value.Fail(fmt::format("{} attaches `{}`, which another joint already attaches", value.what(),
                           child_name),
               "the joints form a tree: let each link be the child of one joint");
  }
  if (!attached[parent]) {
    value.Fail(
        fmt::format("{} hangs on `{}`, which no joint above attaches", value.what(), parent_name),
        "the joints form a tree: list them from the base outward, without a cycle");
  }
  attached[child] = true;
}

// What joints and mounts have in common.
template <class Connection>
Connection ReadConnection(const TomlValue& named, std::string name,
                          const std::vector<std::string>& links) {
  Connection connection;
  connection.name = std::move(name);
  connection.parent = named.At("parent").IndexIn(links, "link");
  connection.child = named.At("child").IndexIn(links, "link");
  return connection;
}

Joint ReadJoint(const TomlValue& named, const JointType& type, Joint joint) {
  named.AllowKeys(KeysOf(type.name));
  joint.kind = type.kind;
  joint.axis = ReadAxis(named.At("axis"));
  type.read(named, joint);
  joint.gains = ReadGains(named);
  joint.passive = ReadPassiveForces(named);
  return joint;
}

Mount ReadMount(const TomlValue& named, const MountType& type, Mount mount) {
  named.AllowKeys(KeysOf(type.name));
  mount.kind = type.kind;
  type.read(named, mount);
  return mount;
}

// Adds one of either kind to the robot.
void ReadEntry(const TomlValue& value, const std::vector<std::string>& links,
               std::vector<bool>& attached, RobotDescription& robot) {
  const TomlValue name_value = value.At("name");
  const std::string name = name_value.Name();
  const TomlValue named = value.Called(fmt::format("joint `{}`", name));
  CheckIsNew(name_value, name, "joint", robot.joints);
  CheckIsNew(name_value, name, "joint", robot.mounts);
  const size_t type = TypeOf(named);
  if (type < kJointTypes.size()) {
    robot.joints.push_back(
        ReadJoint(named, kJointTypes[type], ReadConnection<Joint>(named, name, links)));
    CheckPlaceInTree(named, robot.joints.back().parent, robot.joints.back().child, attached, robot);
  } else {
    robot.mounts.push_back(ReadMount(named, kMountTypes[type - kJointTypes.size()],
                                     ReadConnection<Mount>(named, name, links)));
    CheckPlaceInTree(named, robot.mounts.back().parent, robot.mounts.back().child, attached, robot);
  }
}

}  // namespace

void ReadJoints(const TomlValue& root, RobotDescription& robot) {
  const std::vector<std::string> links = NamesOf(robot.links);
  std::vector<bool> attached(links.size(), false);
  attached[0] = true;
  const TomlValue list = root.At("joints");
  for (const TomlValue& value : list.Items()) ReadEntry(value, links, attached, robot);
  for (size_t i = 0; i < attached.size(); ++i) {
    if (attached[i]) continue;
    list.Fail(fmt::format("no joint attaches the link `{}`", links[i]),
              "add a joint with it as `child`");
  }
}

}  // namespace robot
