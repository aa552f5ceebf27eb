#include "runtime/import/robot_toml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <numbers>

#include "plugins/robot/kind_names.h"

namespace runtime {
namespace {

// What is less than a billionth is rounding.
std::string Number(double value) {
  if (std::abs(value) < 1e-9) return "0";
  return fmt::format("{:.6g}", value);
}

std::string Numbers(const robot::Vector3& v) {
  return fmt::format("[{}, {}, {}]", Number(v[0]), Number(v[1]), Number(v[2]));
}

// With all digits: it has to be of length 1.
std::string Numbers(const robot::Quaternion& q) {
  return fmt::format("[{:.9g}, {:.9g}, {:.9g}, {:.9g}]", q[0], q[1], q[2], q[3]);
}

// What is less than a billionth of the largest is rounding.
std::string InertiaText(const robot::Inertia& m) {
  const double least = 1e-9 * std::max({m.xx, m.yy, m.zz});
  std::string text;
  for (const double value : {m.xx, m.yy, m.zz, m.xy, m.xz, m.yz}) {
    text += fmt::format("{}{:.6g}", text.empty() ? "" : ", ", std::abs(value) < least ? 0 : value);
  }
  return "[" + text + "]";
}

// A text in quotes.
std::string Text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return quoted + '"';
}

// { key = value, ... }
class Row {
 public:
  void Add(const char* key, const std::string& value) {
    text_ += fmt::format("{}{} = {}", text_.empty() ? "" : ", ", key, value);
  }
  void AddIf(bool is_there, const char* key, double value) {
    if (is_there) Add(key, Number(value));
  }
  void AddIf(const std::optional<double>& value, const char* key, double unless) {
    if (value && *value != unless) Add(key, Number(*value));
  }
  std::string Line() const { return fmt::format("  {{ {} }},\n", text_); }

 private:
  std::string text_;
};

std::string PointsText(const std::vector<robot::Vector3>& points) {
  std::string text;
  for (const robot::Vector3& point : points) text += (text.empty() ? "" : ", ") + Numbers(point);
  return "[" + text + "]";
}

void AddShape(const robot::LinkShape& shape, Row& row) {
  constexpr const char* kAxes[] = {"\"x\"", "\"y\"", "\"z\""};
  row.Add("shape", Text(robot::NameOf(shape.kind)));
  switch (shape.kind) {
    case robot::ShapeKind::kBox:
      return row.Add("size", Numbers(shape.size));
    case robot::ShapeKind::kSphere:
      return row.Add("radius", Number(shape.radius));
    case robot::ShapeKind::kCapsule:
    case robot::ShapeKind::kCylinder:
      row.Add("axis", kAxes[shape.axis]);
      row.Add("radius", Number(shape.radius));
      return row.Add("length", Number(shape.length));
    case robot::ShapeKind::kConvex:
      return row.Add("points", PointsText(shape.points));
  }
  std::abort();
}

bool IsTurned(const robot::Quaternion& q) { return std::abs(std::abs(q[0]) - 1) > 1e-9; }

Row ConnectionRow(const robot::RobotDescription& robot, const std::string& name, const char* type,
                  int parent, int child) {
  Row row;
  row.Add("name", Text(name));
  row.Add("type", Text(type));
  row.Add("parent", Text(robot.links[static_cast<size_t>(parent)].name));
  row.Add("child", Text(robot.links[static_cast<size_t>(child)].name));
  return row;
}

void AddStops(const robot::Joint& joint, Row& row) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  switch (joint.kind) {
    case robot::JointKind::kContinuous:
      return;
    case robot::JointKind::kHinge:
      return row.Add("stops_deg", fmt::format("[{}, {}]", Number(joint.low * kDegrees),
                                              Number(joint.high * kDegrees)));
    case robot::JointKind::kSlider:
      row.AddIf(joint.radius != 1, "radius", joint.radius);
      return row.Add("travel", fmt::format("[{}, {}]", Number(joint.low * joint.radius),
                                           Number(joint.high * joint.radius)));
  }
}

std::string JointLine(const robot::RobotDescription& robot, const robot::Joint& joint) {
  Row row = ConnectionRow(robot, joint.name, robot::NameOf(joint.kind), joint.parent, joint.child);
  row.Add("axis", Numbers(joint.axis));
  if (joint.kind != robot::JointKind::kSlider) row.Add("anchor", Numbers(joint.anchor));
  AddStops(joint, row);
  if (joint.gains.max_torque == 0.) {
    row.Add("passive", "true");
  } else {
    row.AddIf(joint.gains.stiffness, "stiffness", robot.controller.stiffness);
    row.AddIf(joint.gains.damping, "damping", robot.controller.damping);
    row.AddIf(joint.gains.max_torque, "max_torque", robot.controller.max_torque);
    row.AddIf(joint.gains.max_speed, "max_speed", robot.controller.max_speed);
  }
  const robot::PassiveForces& forces = joint.passive;
  row.AddIf(forces.spring > 0, "spring", forces.spring);
  row.AddIf(forces.spring > 0 && forces.spring_rest != 0, "spring_rest", forces.spring_rest);
  row.AddIf(forces.damper > 0, "damper", forces.damper);
  row.AddIf(forces.friction > 0, "friction", forces.friction);
  row.AddIf(forces.armature > 0, "armature", forces.armature);
  return row.Line();
}

std::string MountLine(const robot::RobotDescription& robot, const robot::Mount& mount) {
  const bool is_ball = mount.kind == robot::MountKind::kBall;
  Row row = ConnectionRow(robot, mount.name, is_ball ? "ball" : "fixed", mount.parent, mount.child);
  if (is_ball) row.Add("anchor", Numbers(mount.anchor));
  row.AddIf(mount.damper > 0, "damper", mount.damper);
  return row.Line();
}

std::string SitesText(const robot::RobotDescription& robot) {
  if (robot.sites.empty()) return "";
  std::string text = "\nsites = [\n";
  for (const robot::Site& site : robot.sites) {
    Row row;
    row.Add("name", Text(site.name));
    row.Add("link", Text(robot.links[static_cast<size_t>(site.link)].name));
    row.Add("position", Numbers(site.position));
    if (IsTurned(site.orientation)) row.Add("orientation", Numbers(site.orientation));
    text += row.Line();
  }
  return text + "]\n";
}

std::string PoseText(const robot::RobotDescription& robot, const robot::Pose& pose) {
  std::string text = fmt::format("\n[[poses]]\nname = {}\nposition = {}\n", Text(pose.name),
                                 Numbers(pose.position));
  if (IsTurned(pose.orientation))
    text += fmt::format("orientation = {}\n", Numbers(pose.orientation));
  std::string joints;
  for (size_t i = 0; i < pose.joint_angles.size(); ++i) {
    if (std::abs(pose.joint_angles[i]) < 1e-9) continue;
    joints += fmt::format("{} = {}\n", robot.joints[i].name, Number(pose.joint_angles[i]));
  }
  return joints.empty() ? text : text + "\n[poses.joints]\n" + joints;
}

std::string DofText(const robot::RobotDescription& robot, const robot::DofConfiguration& dof) {
  std::string text =
      fmt::format("\n[[dof_configurations]]\nname = {}\ncoordinates = [\n", Text(dof.name));
  for (int coordinate = 0; coordinate < dof.dof(); ++coordinate) {
    const int own = dof.representatives[static_cast<size_t>(coordinate)];
    std::string also;
    for (const robot::Coupling& coupling : dof.couplings) {
      if (coupling.coordinate != coordinate || coupling.joint == own) continue;
      also += fmt::format("{}{} = {}", also.empty() ? "" : ", ",
                          robot.joints[static_cast<size_t>(coupling.joint)].name, coupling.factor);
    }
    text +=
        fmt::format("  {{ joint = {}{} }},\n", Text(robot.joints[static_cast<size_t>(own)].name),
                    also.empty() ? "" : fmt::format(", also = {{ {} }}", also));
  }
  return text + "]\n";
}

std::string PairsText(const robot::RobotDescription& robot) {
  if (robot.contact_exclusions.empty()) return "";
  std::string text = "\ncontact_exclusions = [\n";
  for (const auto& [first, second] : robot.contact_exclusions) {
    text += fmt::format("  [{}, {}],\n", Text(robot.links[static_cast<size_t>(first)].name),
                        Text(robot.links[static_cast<size_t>(second)].name));
  }
  return text + "]\n";
}

std::string ControllerText(const robot::Controller& controller) {
  return fmt::format(
      "\ncontroller = {{ stiffness = {}, damping = {}, max_torque = {}, time_step = {} }}\n",
      Number(controller.stiffness), Number(controller.damping), Number(controller.max_torque),
      Number(controller.time_step));
}

std::string GroupsText(const robot::RobotDescription& robot) {
  if (robot.link_groups.empty()) return "";
  std::string text = "\n[link_groups]\n";
  for (const robot::Group& group : robot.link_groups) {
    std::string members;
    for (const int link : group.members) {
      members += fmt::format("{}{}", members.empty() ? "" : ", ",
                             Text(robot.links[static_cast<size_t>(link)].name));
    }
    text += fmt::format("{} = [{}]\n", group.name, members);
  }
  return text;
}

// A tree has to be listed from the base outwards.
std::string ConnectionsText(const robot::RobotDescription& robot) {
  std::string text = "\njoints = [\n";
  for (const robot::Branch& branch : robot.Branches()) {
    text += branch.joint >= 0 ? JointLine(robot, robot.joints[static_cast<size_t>(branch.joint)])
                              : MountLine(robot, robot.mounts[static_cast<size_t>(branch.mount)]);
  }
  return text + "]\n";
}

}  // namespace

std::string LinkText(const robot::Link& link) {
  Row row;
  row.Add("name", Text(link.name));
  AddShape(link.shape, row);
  row.Add("mass", Number(link.mass));
  row.Add("position", Numbers(link.position));
  robot::Vector3 place = link.shape.position;
  if (std::hypot(place[0], place[1], place[2]) > 1e-9) {
    for (size_t i = 0; i < 3; ++i) place[i] += link.position[i];
    row.Add("shape_position", Numbers(place));
  }
  if (IsTurned(link.shape.orientation))
    row.Add("shape_orientation", Numbers(link.shape.orientation));
  if (link.inertia) {
    row.Add("inertia", InertiaText(*link.inertia));
  }
  row.AddIf(link.friction < robot::kUnlimited, "friction", link.friction);
  return row.Line();
}

std::string ToToml(const robot::RobotDescription& robot, const std::vector<std::string>& comments) {
  std::string text;
  for (const std::string& comment : comments) text += fmt::format("# {}\n", comment);
  text += fmt::format("\nname = {}\ndoc = {}\n", Text(robot.name), Text(robot.doc));
  if (robot.has_fixed_base) text += "base = \"fixed\"\n";
  text += "\nlinks = [\n";
  for (const robot::Link& link : robot.links) text += LinkText(link);
  text += "]\n";
  text += ConnectionsText(robot) + SitesText(robot) + PairsText(robot);
  text += ControllerText(robot.controller);
  for (const robot::Pose& pose : robot.poses) text += PoseText(robot, pose);
  text += GroupsText(robot);
  for (const robot::DofConfiguration& dof : robot.dof_configurations) text += DofText(robot, dof);
  return text;
}

}  // namespace runtime
