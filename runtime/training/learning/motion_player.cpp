#include "runtime/training/learning/motion_player.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "runtime/core/module/connections.h"
#include "runtime/training/learning/dof_configuration.h"
#include "runtime/training/learning/robot_sensor_in.h"

namespace runtime {
namespace {

constexpr double kWidestHalf = 2;  // of a coordinate's range [rad]

}  // namespace

MotionPlayer::MotionPlayer(std::string name, const Context& context)
    : Module(std::move(name)),
      robot_(*context.robot),
      joint_angle_(MakeSensorIn(this, robot::SensorId::kJointAngle)) {
  AddParameter({.name = "dof",
                .doc = "DoF configuration of the robot; \"all\" moves each joint by itself",
                .target = &dof_name_,
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
  AddParameter({.name = "action_steps",
                .doc = "time steps of an action, for what a task pays once per action",
                .target = &action_steps_,
                .minimum = 1});
}

void MotionPlayer::Start() {
  RequireConnections(*this);
  if (settings_.lowest_frequency > settings_.highest_frequency) {
    throw UserError(
        fmt::format("`{0}.lowest_frequency` is {1} Hz, more than "
                    "`{0}.highest_frequency` {2} Hz",
                    name(), settings_.lowest_frequency, settings_.highest_frequency));
  }
  dof_ = FindDofOrAll(robot_, dof_name_, name() + ".dof");
  const auto joints = static_cast<int>(robot_.joints.size());
  mapping_ = DofMapping(dof_, joints);
  low_.resize(joints);
  high_.resize(joints);
  for (int joint = 0; joint < joints; ++joint) {
    low_[joint] = robot_.joints[static_cast<size_t>(joint)].low;
    high_[joint] = robot_.joints[static_cast<size_t>(joint)].high;
  }
  Eigen::VectorXd centers(dof_.dof()), halves(dof_.dof());
  for (int i = 0; i < dof_.dof(); ++i) {
    const int joint = dof_.representatives[static_cast<size_t>(i)];
    centers[i] = (low_[joint] + high_[joint]) / 2;
    halves[i] = std::min((high_[joint] - low_[joint]) / 2, kWidestHalf);
  }
  motion_ = ParametricMotion(settings_, std::move(centers), std::move(halves));
  rest_.setZero(dof_.dof());
  displacement_.setZero(dof_.dof());
  rest_pose_.setZero(joints);
  joint_targets_.setZero(joints);
  standstill_ = motion_.Standstill(rest_);
}

void MotionPlayer::StartOfEpisode() {
  rest_pose_ = Eigen::VectorXd::Map(joint_angle_().reals(), rest_pose_.size());
  for (int i = 0; i < dof_.dof(); ++i) {
    rest_[i] = rest_pose_[dof_.representatives[static_cast<size_t>(i)]];
  }
  standstill_ = motion_.Standstill(rest_);
  joint_targets_ = rest_pose_;
  steps_ = 0;
  steps_left_ = 0;
}

void MotionPlayer::Execute(const Eigen::VectorXd& action) {
  if (action.size() != motion_.size()) {
    throw UserError(fmt::format("`{}` gets an action of {} numbers, and its motions have {}",
                                name(), action.size(), motion_.size()));
  }
  motion_.Take(action, rest_);
  frequency_ = motion_.frequency();
  steps_left_ = action_steps_;
}

void MotionPlayer::StartOfTimeStep(double time_step) {
  if (steps_left_ == 0) return;
  displacement_ = motion_.At(static_cast<double>(steps_) * time_step) - rest_;
  mapping_.Apply(displacement_, joint_targets_);
  joint_targets_ = (joint_targets_ + rest_pose_).cwiseMax(low_).cwiseMin(high_);
}

void MotionPlayer::EndOfTimeStep(double) {
  ++steps_;
  if (steps_left_ == 0 || --steps_left_ > 0) return;
  end_of_action_();  // usually starts the next one
}

}  // namespace runtime
