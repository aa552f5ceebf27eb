#include "runtime/training/learning/joint_motion.h"

#include <algorithm>
#include <utility>

namespace runtime {
namespace {

constexpr double kWidestHalf = 2;  // of a coordinate's range [rad]

}  // namespace

JointMotion::JointMotion(const robot::RobotDescription& robot, robot::DofConfiguration dof,
                         const ParametricMotion::Settings& settings)
    : dof_(std::move(dof)), mapping_(dof_, static_cast<int>(robot.joints.size())) {
  const auto joints = static_cast<int>(robot.joints.size());
  low_.resize(joints);
  high_.resize(joints);
  for (int joint = 0; joint < joints; ++joint) {
    low_[joint] = robot.joints[static_cast<size_t>(joint)].low;
    high_[joint] = robot.joints[static_cast<size_t>(joint)].high;
  }
  Eigen::VectorXd centers(dof_.dof()), halves(dof_.dof());
  for (int i = 0; i < dof_.dof(); ++i) {
    const int joint = dof_.representatives[static_cast<size_t>(i)];
    centers[i] = (low_[joint] + high_[joint]) / 2;
    halves[i] = std::min((high_[joint] - low_[joint]) / 2, kWidestHalf);
  }
  motion_ = ParametricMotion(settings, std::move(centers), std::move(halves));
  rest_.setZero(dof_.dof());
  displacement_.setZero(dof_.dof());
  pose_.setZero(joints);
  standstill_ = motion_.Standstill(rest_);
}

void JointMotion::SetPose(const Eigen::VectorXd& joint_angles) {
  pose_ = joint_angles;
  for (int i = 0; i < dof_.dof(); ++i) {
    rest_[i] = pose_[dof_.representatives[static_cast<size_t>(i)]];
  }
  standstill_ = motion_.Standstill(rest_);
}

void JointMotion::ComputeTargets(double time, Eigen::VectorXd& targets) {
  displacement_ = motion_.At(time) - rest_;
  mapping_.Apply(displacement_, targets);
  targets = (targets + pose_).cwiseMax(low_).cwiseMin(high_);
}

}  // namespace runtime
