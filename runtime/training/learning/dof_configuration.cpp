#include "runtime/training/learning/dof_configuration.h"

#include <fmt/format.h>

#include <vector>

#include "runtime/base/suggestion.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

constexpr const char* kAll = "all";

[[noreturn]] void ThrowUnknown(const robot::RobotDescription& robot, const std::string& name,
                               const std::string& parameter, std::vector<std::string> names) {
  for (const robot::DofConfiguration& dof : robot.dof_configurations) names.push_back(dof.name);
  throw UserError(fmt::format("`{}`: the robot `{}` has no DoF configuration `{}`{}", parameter,
                              robot.name, name, Suggestion(name, names)));
}

}  // namespace

const robot::DofConfiguration& FindDof(const robot::RobotDescription& robot,
                                       const std::string& name, const std::string& parameter) {
  if (const robot::DofConfiguration* found = robot.FindDof(name)) return *found;
  ThrowUnknown(robot, name, parameter, {});
}

robot::DofConfiguration FindDofOrAll(const robot::RobotDescription& robot, const std::string& name,
                                     const std::string& parameter) {
  if (const robot::DofConfiguration* found = robot.FindDof(name)) return *found;
  if (name != kAll) ThrowUnknown(robot, name, parameter, {kAll});
  robot::DofConfiguration all;
  all.name = kAll;
  for (int joint = 0; joint < static_cast<int>(robot.joints.size()); ++joint) {
    all.representatives.push_back(joint);
    all.couplings.push_back({.joint = joint, .coordinate = joint});
  }
  return all;
}

}  // namespace runtime
