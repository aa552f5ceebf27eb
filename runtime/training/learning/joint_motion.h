#pragma once

#include <Eigen/Core>
#include <optional>

#include "plugins/robot/robot_description.h"
#include "runtime/training/learning/dof_mapping.h"
#include "runtime/training/learning/joint_stops.h"
#include "runtime/training/learning/parametric_motion.h"
#include "runtime/training/learning/policy_graph.h"

namespace runtime {

// A ParametricMotion as targets of a robot's joints: a pose, plus how far the motion moves the
// coordinates of a DoF configuration away from it, each within its stops. Coordinates range over
// the stops of the joint that stands for them, but not more than 2 rad to either side of their
// center. A second configuration of the same coordinates can move other joints by what these
// coordinates are half a period later. Nothing but the constructor allocates.
class JointMotion {
 public:
  JointMotion() = default;
  JointMotion(const robot::RobotDescription& robot, robot::DofConfiguration dof,
              const ParametricMotion::Settings& settings,
              const std::optional<robot::DofConfiguration>& half_period_later = {});

  int size() const { return motion_.size(); }  // of the parameters
  // The parameters of no motion.
  const Eigen::VectorXd& standstill() const { return standstill_; }
  double frequency() const { return motion_.frequency(); }

  // From now on motions are about the pose with these joint angles [rad].
  void SetPose(const Eigen::VectorXd& joint_angles);
  void Take(const Eigen::VectorXd& parameters) { motion_.Take(parameters, rest_); }
  // Those of the motion that was taken, at `time` [s]; `targets` has an element for each joint.
  void ComputeTargets(double time, Eigen::VectorXd& targets);
  // The same for all times.
  PolicyMotion AsFunctionOfTime() const;

 private:
  robot::DofConfiguration dof_;
  DofMapping mapping_;
  std::optional<DofMapping> half_period_later_;
  JointStops stops_;
  ParametricMotion motion_;
  Eigen::VectorXd pose_;           // of the joints
  Eigen::VectorXd rest_;           // of the coordinates
  Eigen::VectorXd displacement_;   // scratch: of the coordinates
  Eigen::VectorXd later_targets_;  // scratch: of the joints
  Eigen::VectorXd standstill_;
};

}  // namespace runtime
