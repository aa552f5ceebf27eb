#pragma once

#include <string>

#include "runtime/core/module/context.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/sensor_data.h"
#include "runtime/core/module/values.h"
#include "runtime/training/learning/joint_motion.h"

namespace runtime {

// What modules that move a robot by a JointMotion have in common: the parameters that say what its
// motions are like, a clock that starts with each episode, and the pose that the episode starts in,
// about which motions are.
class MotionModule : public Module {
 public:
  // Throws UserError where the robot has no such DoF configuration or symmetry, or the frequencies
  // are none.
  void Start() override;

 protected:
  MotionModule(std::string name, const Context& context);

  const ParametricMotion::Settings& settings() const { return settings_; }
  JointMotion& motion() { return motion_; }
  const JointMotion& motion() const { return motion_; }
  const Eigen::VectorXd& joint_targets() const { return joint_targets_; }

  // The robot is to stay as it is, until it moves.
  void BeginEpisode();
  // The targets are those of the motion that was taken, for a time step of this length [s].
  void Move(double time_step);
  void CountTimeStep() { ++steps_; }
  double TimeAt(double time_step) const { return static_cast<double>(steps_) * time_step; }

 private:
  JointMotion MakeMotion() const;

  const robot::RobotDescription& robot_;
  std::string dof_ = "5";
  std::string symmetry_ = "none";
  ParametricMotion::Settings settings_;
  JointMotion motion_;
  Eigen::VectorXd joint_targets_;
  int64_t steps_ = 0;  // since the start of the episode

  SensorIn joint_angle_;
  Out<Eigen::VectorXd> joint_targets_out_{this, "joint_targets", &joint_targets_};
};

}  // namespace runtime
