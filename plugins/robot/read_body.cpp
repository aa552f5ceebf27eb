#include <cmath>
#include <numbers>

#include "plugins/robot/read_parts.h"

namespace robot {
namespace {

const std::vector<std::string> kAxes = {"x", "y", "z"};

// The keys of a link that belong to its shape depend on the shape's kind.
LinkShape ReadShape(const TomlValue& link) {
  LinkShape shape;
  switch (link.At("shape").IndexIn({"box", "capsule", "sphere"}, "shape")) {
    case 0: {
      link.AllowKeys({"name", "shape", "size", "mass", "position"});
      shape.kind = ShapeKind::kBox;
      const TomlValue size = link.At("size");
      shape.size = size.ToVector3();
      for (const TomlValue& extent : size.Items()) extent.PositiveNumber();
      break;
    }
    case 1: {
      link.AllowKeys({"name", "shape", "axis", "radius", "length", "mass", "position"});
      shape.kind = ShapeKind::kCapsule;
      shape.axis = link.At("axis").IndexIn(kAxes, "axis");
      shape.radius = link.At("radius").PositiveNumber();
      const TomlValue length = link.At("length");
      shape.length = length.Number();
      if (shape.length <= 2 * shape.radius) {
        length.Fail(length.what() + " does not exceed its two caps",
                    "give the total length, more than twice the radius, or make it a sphere");
      }
      break;
    }
    default:
      link.AllowKeys({"name", "shape", "radius", "mass", "position"});
      shape.kind = ShapeKind::kSphere;
      shape.radius = link.At("radius").PositiveNumber();
  }
  return shape;
}

// "z", or a direction as three numbers.
Vector3 ReadAxis(const TomlValue& value) {
  if (value.IsText()) {
    Vector3 axis{};
    axis[value.IndexIn(kAxes, "axis")] = 1;
    return axis;
  }
  Vector3 axis = value.ToVector3();
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  if (length < 1e-6) value.Fail(value.what() + " has no direction", "give \"x\", \"y\" or \"z\"");
  for (double& component : axis) component /= length;
  return axis;
}

void ReadStops(const TomlValue& value, Joint& joint) {
  const std::vector<double> stops = value.Numbers(2);
  if (stops[0] >= stops[1]) {
    value.Fail(value.what() + ": the low stop is not below the high stop", "write [low, high]");
  }
  if (stops[0] < -180 || stops[1] > 180) {
    value.Fail(value.what() + " exceed -180 to 180 degrees, the range that a hinge can measure",
               "give [-180, 180] to a joint without stops");
  }
  joint.low = stops[0] * std::numbers::pi / 180;
  joint.high = stops[1] * std::numbers::pi / 180;
}

// Joints are listed from the base outwards, each link below exactly one joint: then they form a
// tree, and a single pass over them in order reaches every link after its parent.
void CheckPlaceInTree(const TomlValue& value, const Joint& joint, std::vector<bool>& attached,
                      const RobotDescription& robot) {
  const std::string& parent = robot.links[joint.parent].name;
  const std::string& child = robot.links[joint.child].name;
  if (joint.child == 0) {
    value.Fail(fmt::format("{} hangs the base link `{}` on another link", value.what(), child),
               "swap `parent` and `child`, or list another link first");
  }
  if (attached[joint.child]) {
    value.Fail(
        fmt::format("{} attaches `{}`, which another joint already attaches", value.what(), child),
        "the joints form a tree: let each link be the child of one joint");
  }
  if (!attached[joint.parent]) {
    value.Fail(fmt::format("{} hangs on `{}`, which no joint above attaches", value.what(), parent),
               "the joints form a tree: list them from the base outward, without a cycle");
  }
  attached[joint.child] = true;
}

Joint ReadJoint(const TomlValue& value, const RobotDescription& robot) {
  value.AllowKeys({"name", "parent", "child", "axis", "anchor", "stops_deg"});
  const std::vector<std::string> links = NamesOf(robot.links);
  Joint joint;
  joint.name = value.At("name").Name();
  const TomlValue named = value.Called(fmt::format("joint `{}`", joint.name));
  joint.parent = named.At("parent").IndexIn(links, "link");
  joint.child = named.At("child").IndexIn(links, "link");
  joint.axis = ReadAxis(named.At("axis"));
  joint.anchor = named.At("anchor").ToVector3();
  ReadStops(named.At("stops_deg"), joint);
  return joint;
}

}  // namespace

std::vector<Link> ReadLinks(const TomlValue& root) {
  std::vector<Link> links;
  const TomlValue list = root.At("links");
  for (const TomlValue& value : list.Items()) {
    Link link;
    const TomlValue name = value.At("name");
    link.name = name.Name();
    CheckIsNew(name, link.name, "link", links);
    const TomlValue named = value.Called(fmt::format("link `{}`", link.name));
    link.shape = ReadShape(named);
    link.mass = named.At("mass").PositiveNumber();
    const TomlValue position = named.At("position");
    link.position = position.ToVector3();
    if (links.empty() && link.position != Vector3{}) {
      position.Fail(fmt::format("the base link `{}` is not at the origin", link.name),
                    "give all positions relative to the center of the first link");
    }
    links.push_back(std::move(link));
  }
  if (links.empty()) list.Fail("the robot has no link", "describe at least its base");
  return links;
}

std::vector<Joint> ReadJoints(const TomlValue& root, const RobotDescription& robot) {
  std::vector<Joint> joints;
  std::vector<bool> attached(robot.links.size(), false);
  attached[0] = true;
  const TomlValue list = root.At("joints");
  for (const TomlValue& value : list.Items()) {
    Joint joint = ReadJoint(value, robot);
    CheckIsNew(value.At("name"), joint.name, "joint", joints);
    CheckPlaceInTree(value.Called(fmt::format("joint `{}`", joint.name)), joint, attached, robot);
    joints.push_back(std::move(joint));
  }
  for (size_t i = 0; i < attached.size(); ++i) {
    if (attached[i]) continue;
    list.Fail(fmt::format("no joint attaches the link `{}`", robot.links[i].name),
              "add a joint with it as `child`");
  }
  return joints;
}

}  // namespace robot
