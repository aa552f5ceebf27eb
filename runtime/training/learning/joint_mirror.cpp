#include "runtime/training/learning/joint_mirror.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

constexpr double kSamePlace = 1e-3;  // [m]
constexpr double kSameAxis = 1e-3;

robot::Vector3 Mirrored(const robot::Vector3& place) { return {place[0], -place[1], place[2]}; }

double Distance(const robot::Vector3& a, const robot::Vector3& b, double sign = 1) {
  return std::hypot(a[0] - sign * b[0], a[1] - sign * b[1], a[2] - sign * b[2]);
}

// What turns about an axis turns the other way about the mirrored axis.
robot::Vector3 MirroredAxis(const robot::Joint& joint) {
  const robot::Vector3 mirrored = Mirrored(joint.axis);
  if (joint.kind == robot::JointKind::kSlider) return mirrored;
  return {-mirrored[0], -mirrored[1], -mirrored[2]};
}

// Where a joint is: a slider's axis has no place of its own, what it moves has.
const robot::Vector3& PlaceOf(const robot::RobotDescription& robot, const robot::Joint& joint) {
  if (joint.kind != robot::JointKind::kSlider) return joint.anchor;
  return robot.links[static_cast<size_t>(joint.child)].position;
}

MirroredJoint MirrorJoint(const robot::RobotDescription& robot, const robot::Joint& joint) {
  const robot::Vector3 place = Mirrored(PlaceOf(robot, joint));
  const robot::Vector3 axis = MirroredAxis(joint);
  for (size_t other = 0; other < robot.joints.size(); ++other) {
    if (robot.joints[other].kind != joint.kind) continue;
    if (Distance(PlaceOf(robot, robot.joints[other]), place) > kSamePlace) continue;
    for (const double sign : {1.0, -1.0}) {
      if (Distance(robot.joints[other].axis, axis, sign) < kSameAxis) {
        return {static_cast<int>(other), sign};
      }
    }
  }
  return {};
}

bool Moves(const robot::DofConfiguration& dof, int joint) {
  return std::any_of(dof.couplings.begin(), dof.couplings.end(),
                     [joint](const robot::Coupling& coupling) { return coupling.joint == joint; });
}

}  // namespace

std::vector<MirroredJoint> MirrorJoints(const robot::RobotDescription& robot) {
  std::vector<MirroredJoint> mirrored;
  for (const robot::Joint& joint : robot.joints) mirrored.push_back(MirrorJoint(robot, joint));
  return mirrored;
}

robot::DofConfiguration MirrorDof(const robot::RobotDescription& robot,
                                  const robot::DofConfiguration& dof,
                                  const std::string& parameter) {
  const std::vector<MirroredJoint> mirrored = MirrorJoints(robot);
  robot::DofConfiguration other = dof;
  for (robot::Coupling& coupling : other.couplings) {
    const std::string& name = robot.joints[static_cast<size_t>(coupling.joint)].name;
    const MirroredJoint& image = mirrored[static_cast<size_t>(coupling.joint)];
    if (image.joint < 0) {
      throw UserError(fmt::format("`{}`: the robot `{}` has no joint that mirrors `{}`", parameter,
                                  robot.name, name));
    }
    if (Moves(dof, image.joint)) {
      throw UserError(fmt::format(
          "`{}`: the DoF configuration `{}` moves `{}` and its mirror image `{}`; "
          "choose one that moves one side, or \"all\"",
          parameter, dof.name, name, robot.joints[static_cast<size_t>(image.joint)].name));
    }
    coupling = {.joint = image.joint,
                .coordinate = coupling.coordinate,
                .factor = image.sign * coupling.factor};
  }
  return other;
}

std::vector<int> OneSide(const robot::RobotDescription& robot) {
  std::vector<int> side;
  for (int joint = 0; const MirroredJoint& mirrored : MirrorJoints(robot)) {
    if (mirrored.joint > joint) side.push_back(joint);
    ++joint;
  }
  return side;
}

}  // namespace runtime
