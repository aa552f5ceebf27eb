#include "runtime/training/learning/joint_motion.h"

#include <algorithm>
#include <utility>

namespace runtime {
namespace {

constexpr double kWidestHalf = 2;  // of a coordinate's range [rad]

}  // namespace

JointMotion::JointMotion(const robot::RobotDescription& robot, robot::DofConfiguration dof,
                         const ParametricMotion::Settings& settings,
                         const std::optional<robot::DofConfiguration>& half_period_later)
    : dof_(std::move(dof)), mapping_(dof_, static_cast<int>(robot.joints.size())), stops_(robot) {
  Eigen::VectorXd centers(dof_.dof()), halves(dof_.dof());
  for (int i = 0; i < dof_.dof(); ++i) {
    const int joint = dof_.representatives[static_cast<size_t>(i)];
    const bool has_stops = robot.joints[static_cast<size_t>(joint)].HasStops();
    centers[i] = has_stops ? (stops_.low[joint] + stops_.high[joint]) / 2 : 0;
    halves[i] = std::min((stops_.high[joint] - stops_.low[joint]) / 2, kWidestHalf);
  }
  motion_ = ParametricMotion(settings, std::move(centers), std::move(halves));
  if (half_period_later) half_period_later_.emplace(*half_period_later, mapping_.joints());
  rest_.setZero(dof_.dof());
  displacement_.setZero(dof_.dof());
  pose_.setZero(stops_.low.size());
  later_targets_.setZero(stops_.low.size());
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
  if (half_period_later_) {
    displacement_ = motion_.At(time + 0.5 / frequency()) - rest_;
    half_period_later_->Apply(displacement_, later_targets_);
    targets += later_targets_;
  }
  targets += pose_;
  stops_.Limit(targets);
}

PolicyMotion JointMotion::AsFunctionOfTime() const {
  const bool is_periodic = motion_.is_periodic();
  Eigen::MatrixXd columns = motion_.Columns();
  const Eigen::Index places = is_periodic ? 1 : columns.cols();  // the rest are oscillations
  columns.leftCols(places).colwise() -= rest_;
  Eigen::MatrixXd shape = mapping_.factors() * columns;
  if (half_period_later_) {
    for (Eigen::Index k = 1; 2 * k < columns.cols(); k += 2) columns.middleCols<2>(2 * k - 1) *= -1;
    shape += half_period_later_->factors() * columns;
  }
  shape.leftCols(places).colwise() += pose_;
  return {is_periodic, frequency(), shape, stops_.low, stops_.high};
}

}  // namespace runtime
