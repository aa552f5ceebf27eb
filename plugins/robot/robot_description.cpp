#include "plugins/robot/robot_description.h"

namespace robot {
namespace {

template <class Part>
const Part* FindByName(const std::vector<Part>& parts, std::string_view name) {
  for (const Part& part : parts) {
    if (part.name == name) return &part;
  }
  return nullptr;
}

template <class Part>
std::optional<int> FindIndex(const std::vector<Part>& parts, std::string_view name) {
  const Part* part = FindByName(parts, name);
  if (part == nullptr) return std::nullopt;
  return static_cast<int>(part - parts.data());
}

}  // namespace

std::optional<int> RobotDescription::FindLink(std::string_view link) const {
  return FindIndex(links, link);
}

std::optional<int> RobotDescription::FindJoint(std::string_view joint) const {
  return FindIndex(joints, joint);
}

const Pose* RobotDescription::FindPose(std::string_view pose) const {
  return FindByName(poses, pose);
}

const DofConfiguration* RobotDescription::FindDof(std::string_view dof) const {
  return FindByName(dof_configurations, dof);
}

const NetDescription* RobotDescription::FindNet(std::string_view net) const {
  return FindByName(nets, net);
}

Gains RobotDescription::GainsOf(const Joint& joint) const {
  const OwnGains& own = joint.gains;
  return {.stiffness = own.stiffness.value_or(controller.stiffness),
          .damping = own.damping.value_or(controller.damping),
          .max_torque = own.max_torque.value_or(controller.max_torque),
          .max_speed = own.max_speed.value_or(controller.max_speed)};
}

Vector3 RobotDescription::ArmOf(const Site& site) const {
  const Vector3& from = links[site.link].position;
  const Vector3& to = site.position;
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

std::vector<Branch> RobotDescription::Branches() const {
  std::vector<Branch> branches;
  std::vector<bool> attached(links.size(), false);
  attached[0] = true;
  const auto add = [&](const Branch& branch) {
    if (!attached[branch.parent] || attached[branch.child]) return;
    attached[branch.child] = true;
    branches.push_back(branch);
  };
  for (size_t before = 1; before != branches.size();) {
    before = branches.size();
    for (size_t j = 0; j < joints.size(); ++j)
      add({.parent = joints[j].parent, .child = joints[j].child, .joint = static_cast<int>(j)});
    for (size_t m = 0; m < mounts.size(); ++m)
      add({.parent = mounts[m].parent, .child = mounts[m].child, .mount = static_cast<int>(m)});
  }
  return branches;
}

}  // namespace robot
