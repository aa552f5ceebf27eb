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

}  // namespace robot
