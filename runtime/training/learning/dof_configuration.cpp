#include "runtime/training/learning/dof_configuration.h"

#include <fmt/format.h>

#include <numeric>
#include <utility>
#include <vector>

#include "runtime/base/suggestion.h"
#include "runtime/base/user_error.h"
#include "runtime/training/learning/joint_mirror.h"

namespace runtime {
namespace {

constexpr const char* kAll = "all";

[[noreturn]] void ThrowUnknown(const robot::RobotDescription& robot, const std::string& name,
                               const std::string& parameter, std::vector<std::string> names) {
  for (const robot::DofConfiguration& dof : robot.dof_configurations) names.push_back(dof.name);
  throw UserError(fmt::format("`{}`: the robot `{}` has no DoF configuration `{}`{}", parameter,
                              robot.name, name, Suggestion(name, names)));
}

// Those of these joints that have a motor.
std::vector<int> Driven(const robot::RobotDescription& robot, std::vector<int> joints) {
  std::erase_if(joints, [&](int joint) {
    return !robot.GainsOf(robot.joints[static_cast<size_t>(joint)]).HasMotor();
  });
  return joints;
}

// A coordinate for each of these joints.
robot::DofConfiguration EachByItself(const std::string& name, const std::vector<int>& joints) {
  robot::DofConfiguration dof;
  dof.name = name;
  for (const int joint : joints) {
    dof.couplings.push_back({.joint = joint, .coordinate = dof.dof()});
    dof.representatives.push_back(joint);
  }
  return dof;
}

// The configuration of this name, or that of the group of joints, or "all", which is of `all`.
robot::DofConfiguration FindWithGroups(const robot::RobotDescription& robot,
                                       const std::string& name, const std::string& parameter,
                                       const std::vector<int>& all) {
  if (const robot::DofConfiguration* found = robot.FindDof(name)) return *found;
  if (name == kAll) return EachByItself(name, all);
  std::vector<std::string> others = {kAll};
  for (const robot::Group& group : robot.joint_groups) {
    if (group.name == name) return EachByItself(name, group.members);
    others.push_back(group.name);
  }
  ThrowUnknown(robot, name, parameter, std::move(others));
}

}  // namespace

const robot::DofConfiguration& FindDof(const robot::RobotDescription& robot,
                                       const std::string& name, const std::string& parameter) {
  if (const robot::DofConfiguration* found = robot.FindDof(name)) return *found;
  ThrowUnknown(robot, name, parameter, {});
}

robot::DofConfiguration FindDofOrJoints(const robot::RobotDescription& robot,
                                        const std::string& name, const std::string& parameter) {
  std::vector<int> all(robot.joints.size());
  std::iota(all.begin(), all.end(), 0);
  return FindWithGroups(robot, name, parameter, Driven(robot, all));
}

robot::DofConfiguration FindDofOfOneSide(const robot::RobotDescription& robot,
                                         const std::string& name, const std::string& parameter) {
  robot::DofConfiguration dof =
      FindWithGroups(robot, name, parameter, Driven(robot, OneSide(robot)));
  if (dof.dof() > 0) return dof;
  throw UserError(
      fmt::format("the robot `{}` has no joints left and right that mirror each other, for `{}`",
                  robot.name, parameter));
}

}  // namespace runtime
