#include "runtime/training/learning/motion_module.h"

#include <fmt/format.h>

#include <utility>

#include "runtime/core/module/connections.h"
#include "runtime/training/learning/dof_configuration.h"
#include "runtime/training/learning/joint_mirror.h"
#include "runtime/training/learning/robot_sensor_in.h"

namespace runtime {

namespace {

constexpr const char* kNoSymmetry = "none";
constexpr const char* kMirrored = "mirrored";
constexpr const char* kAlternating = "alternating";

}  // namespace

MotionModule::MotionModule(std::string name, const Context& context)
    : Module(std::move(name)),
      robot_(RobotOf(context, this->name())),
      joint_angle_(MakeSensorIn(this, robot::SensorId::kJointAngle)) {
  AddParameter(
      {.name = "dof",
       .doc = "DoF configuration of the robot; \"all\" or a group of joints: each by itself",
       .target = &dof_,
       .is_live = false});
  AddParameter({.name = "symmetry",
                .doc = "of a motion: what is left and what is right mirror each other, at the same "
                       "time or alternating, half a period later; `dof` moves one side",
                .target = &symmetry_,
                .choices = {kNoSymmetry, kMirrored, kAlternating},
                .is_live = false});
  AddParameter({.name = "kind",
                .doc = "whether a motion is repeated, or done once from the start of the episode",
                .target = &settings_.kind,
                .choices = {ParametricMotion::kPeriodic, ParametricMotion::kOneShot},
                .is_live = false});
  const auto add_count = [this](const char* parameter, const char* doc, int* target, double most) {
    AddParameter({.name = parameter,
                  .doc = doc,
                  .target = target,
                  .minimum = 1,
                  .maximum = most,
                  .is_live = false});
  };
  add_count("harmonics", "of a periodic motion, for each coordinate", &settings_.harmonics, 20);
  add_count("knots", "of a motion that is done once, for each coordinate", &settings_.knots, 100);
  const auto add_frequency = [this](const char* parameter, double* target) {
    AddParameter({.name = parameter,
                  .doc = "of a periodic motion; 1 / duration of one that is done once",
                  .target = target,
                  .minimum = 1e-3,
                  .maximum = 1e3,
                  .unit = "Hz",
                  .is_live = false});
  };
  add_frequency("lowest_frequency", &settings_.lowest_frequency);
  add_frequency("highest_frequency", &settings_.highest_frequency);
}

void MotionModule::Start() {
  RequireConnections(*this);
  if (settings_.lowest_frequency > settings_.highest_frequency) {
    throw UserError(
        fmt::format("`{0}.lowest_frequency` is {1} Hz, more than "
                    "`{0}.highest_frequency` {2} Hz",
                    name(), settings_.lowest_frequency, settings_.highest_frequency));
  }
  motion_ = MakeMotion();
  joint_targets_.setZero(static_cast<Eigen::Index>(robot_.joints.size()));
}

JointMotion MotionModule::MakeMotion() const {
  if (symmetry_ == kNoSymmetry) {
    return {robot_, FindDofOrJoints(robot_, dof_, name() + ".dof"), settings_};
  }
  if (symmetry_ == kAlternating && settings_.kind != ParametricMotion::kPeriodic) {
    throw UserError(
        fmt::format("`{0}.symmetry` is `{1}`, but a motion that is done once "
                    "(`{0}.kind`) has no half a period",
                    name(), kAlternating));
  }
  robot::DofConfiguration side = FindDofOfOneSide(robot_, dof_, name() + ".dof");
  const robot::DofConfiguration other = MirrorDof(robot_, side, name() + ".dof");
  if (symmetry_ == kAlternating) return {robot_, std::move(side), settings_, other};
  side.couplings.insert(side.couplings.end(), other.couplings.begin(), other.couplings.end());
  return {robot_, std::move(side), settings_};
}

void MotionModule::BeginEpisode() {
  joint_targets_ = Eigen::VectorXd::Map(joint_angle_().reals(), joint_targets_.size());
  motion_.SetPose(joint_targets_);
  steps_ = 0;
}

void MotionModule::Move(double time_step) {
  motion_.ComputeTargets(TimeAt(time_step), joint_targets_);
}

}  // namespace runtime
