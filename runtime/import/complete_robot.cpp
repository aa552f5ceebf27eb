#include "runtime/import/complete_robot.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "runtime/analysis/robot/body_properties.h"
#include "runtime/analysis/robot/held_pose.h"
#include "runtime/analysis/robot/robot_problems.h"
#include "runtime/import/names.h"
#include "runtime/import/standing_pose.h"
#include "runtime/training/simulation/collision.h"

namespace runtime {
namespace {

using robot::RobotDescription;

constexpr double kTimeStep = 0.005;    // [s]
constexpr double kFullTorqueAt = 0.4;  // [rad]
constexpr double kDampingRatio = 0.5;

double Round(double value) {
  if (value == 0) return 0;
  const double unit = std::pow(10., std::floor(std::log10(std::abs(value))) - 2);
  return std::round(value / unit) * unit;
}

// With which each can hold half of the robot's weight at the end of its limb.
double ProposedTorque(const robot::Joint& joint, double reach, double mass) {
  const double force = mass * robot::kGravity / 2;
  if (joint.kind == robot::JointKind::kSlider) return Round(2 * force);
  return Round(force * std::max(reach, 0.01));
}

// Proposes the torques that nothing says, or that are none.
void ProposeTorques(RobotDescription& robot, const BodyProperties& body,
                    std::vector<std::string>& warnings) {
  constexpr const char* kProposed =
      "each can hold half of the robot's weight at the end of its limb";
  std::vector<std::string> guessed;
  std::vector<std::string> beyond;
  for (size_t i = 0; i < robot.joints.size(); ++i) {
    robot::Joint& joint = robot.joints[i];
    if (joint.gains.max_torque && !body.joints[i].IsBeyondMotors()) continue;
    (joint.gains.max_torque ? beyond : guessed).push_back(joint.name);
    joint.gains.max_torque = ProposedTorque(joint, body.joints[i].reach, body.mass);
  }
  if (!guessed.empty()) {
    warnings.push_back(fmt::format("nothing says how strong the motors of `{}` are: {}",
                                   fmt::join(guessed, "`, `"), kProposed));
  }
  if (!beyond.empty()) {
    warnings.push_back(fmt::format(
        "no motors are as strong as the file has those of `{}`, which could hold up more than five "
        "such robots: instead {}; set `max_torque`",
        fmt::join(beyond, "`, `"), kProposed));
  }
}

void ProposeGains(RobotDescription& robot, std::vector<std::string>& warnings) {
  const BodyProperties body = PropertiesOf(robot);
  ProposeTorques(robot, body, warnings);
  for (size_t i = 0; i < robot.joints.size(); ++i) {
    robot::Joint& joint = robot.joints[i];
    if (joint.gains.max_torque == 0.) continue;  // passive
    const double inertia = body.joints[i].inertia;
    if (!joint.gains.stiffness)
      joint.gains.stiffness = Round(*joint.gains.max_torque / kFullTorqueAt);
    if (!joint.gains.damping) {
      joint.gains.damping = Round(2 * kDampingRatio * std::sqrt(*joint.gains.stiffness * inertia));
    }
  }
}

// The middle of all gains, for a file in which every joint has its own.
void SetController(RobotDescription& robot) {
  robot.controller = {.stiffness = 10, .damping = 1, .max_torque = 10, .time_step = kTimeStep};
  for (const robot::Joint& joint : robot.joints) {
    if (joint.gains.max_torque == 0.) continue;
    robot.controller.stiffness = *joint.gains.stiffness;
    robot.controller.damping = *joint.gains.damping;
    robot.controller.max_torque = *joint.gains.max_torque;
    return;
  }
}

robot::Pose MakePose(const DescribedModel& model, const std::vector<double>& keyframe) {
  const RobotDescription& robot = model.robot;
  robot::Pose pose;
  pose.name = "standing";
  pose.position = model.base;
  for (size_t i = 0; i < robot.joints.size(); ++i) {
    const auto place = static_cast<size_t>(model.qpos[i]);
    const double angle = place < keyframe.size() ? keyframe[place] - model.references[i] : 0;
    pose.joint_angles.push_back(std::clamp(angle, robot.joints[i].low, robot.joints[i].high));
  }
  return pose;
}

// Shapes of models are often within each other where their links are next to each other.
void ExcludeOverlaps(RobotDescription& robot, std::vector<std::string>& warnings) {
  constexpr double kDeepest = 0.005;  // of the robot's size
  const HeldPose held = HoldPose(robot, FindProfile("fast-tree"), robot.poses.front(), kTimeStep);
  std::vector<std::string> pairs;
  for (const Overlap& overlap : held.overlaps) {
    if (overlap.first == Contact::kGround || overlap.depth < kDeepest * held.size) continue;
    robot.contact_exclusions.push_back({overlap.first, overlap.second});
    pairs.push_back(fmt::format("`{}` and `{}`",
                                robot.links[static_cast<size_t>(overlap.first)].name,
                                robot.links[static_cast<size_t>(overlap.second)].name));
  }
  if (!pairs.empty()) {
    warnings.push_back(fmt::format("within each other in the start pose, and so not to collide: {}",
                                   fmt::join(pairs, ", ")));
  }
}

// Puts the robot on the ground; where it does not stand there, in a pose in which it does.
void MakeStand(RobotDescription& robot, std::vector<std::string>& warnings,
               const std::function<void(const std::string&)>& tell) {
  robot::Pose& pose = robot.poses.front();
  pose = PutOnGround(robot, pose);
  if (robot.has_fixed_base) return;
  const HeldPose held = HoldPose(robot, FindProfile("fast-tree"), pose);
  if (held.Stands()) return;
  if (tell) {
    tell(
        "the robot does not stand with the angles of the file; looking for others with which it "
        "does, some seconds ...");
  }
  if (const auto found = FindStandingPose(robot, pose)) {
    pose = *found;
    warnings.push_back(
        "the robot does not stand with the angles of the file: the start pose bends its joints so "
        "that it does; see `trainer robot show`");
    return;
  }
  warnings.push_back(held.failure.empty()
                         ? "the robot does not stand in its start pose, and no other was found: "
                           "bend its joints so that it does, and see `trainer robot show`"
                         : fmt::format("held in its start pose the simulation diverges ({}): see "
                                       "`trainer robot show`",
                                       held.failure));
}

// The links that are on the ground where the robot stands.
void NameFeet(RobotDescription& robot) {
  if (robot.has_fixed_base) return;
  robot::Group feet = {.name = "feet", .members = {}};
  robot::Pose end = robot.poses.front();
  end.position[2] -= 0.002;  // 2 mm into the ground
  for (const Overlap& overlap :
       HoldPose(robot, FindProfile("fast-tree"), end, kTimeStep).overlaps) {
    if (overlap.first == Contact::kGround) feet.members.push_back(overlap.second);
  }
  std::ranges::sort(feet.members);
  if (!feet.members.empty() && !robot.FindLink("feet")) robot.link_groups.push_back(feet);
}

// 1 or -1 as equal or opposite angles are symmetric; 0 where the joints are not.
double Symmetry(const robot::Joint& left, const robot::Joint& right) {
  if (left.kind != right.kind) return 0;
  // A turn seen in a mirror goes the other way about, a shift does not.
  const double sign = left.kind == robot::JointKind::kSlider ? -1 : 1;
  const double cosine = sign * (-left.axis[0] * right.axis[0] + left.axis[1] * right.axis[1] -
                                left.axis[2] * right.axis[2]);
  return std::abs(cosine) < 0.99 ? 0 : std::copysign(1, cosine);
}

// Left and right as one, where names and axes say that they are.
void NameSymmetricDof(RobotDescription& robot) {
  robot::DofConfiguration dof = {.name = "symmetric", .representatives = {}, .couplings = {}};
  std::vector<bool> is_taken(robot.joints.size(), false);
  bool has_pair = false;
  for (size_t i = 0; i < robot.joints.size(); ++i) {
    const std::optional<int> right = robot.FindJoint(OnTheRight(robot.joints[i].name));
    const double factor =
        right ? Symmetry(robot.joints[i], robot.joints[static_cast<size_t>(*right)]) : 0;
    if (factor == 0 || is_taken[i]) continue;
    has_pair = true;
    is_taken[i] = true;
    is_taken[static_cast<size_t>(*right)] = true;
    const int coordinate = dof.dof();
    dof.representatives.push_back(static_cast<int>(i));
    dof.couplings.push_back({static_cast<int>(i), coordinate, 1});
    dof.couplings.push_back({*right, coordinate, factor});
  }
  for (size_t i = 0; i < robot.joints.size(); ++i) {
    if (is_taken[i] || robot.joints[i].gains.max_torque == 0.) continue;
    dof.couplings.push_back({static_cast<int>(i), dof.dof(), 1});
    dof.representatives.push_back(static_cast<int>(i));
  }
  if (has_pair) robot.dof_configurations.push_back(dof);
}

}  // namespace

void CompleteRobot(DescribedModel& model, const std::vector<double>& keyframe,
                   const std::function<void(const std::string&)>& tell) {
  RobotDescription& robot = model.robot;
  SetController(robot);
  robot.poses = {MakePose(model, keyframe)};
  ProposeGains(robot, model.warnings);
  SetController(robot);
  ExcludeOverlaps(robot, model.warnings);
  NameSymmetricDof(robot);
  MakeStand(robot, model.warnings, tell);
  NameFeet(robot);
}

}  // namespace runtime
