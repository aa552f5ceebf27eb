// What the learner knows of the robot: a vector whose elements are, with d coordinates in the
// robot's DoF configuration,
//
//   z, qw, qx, qy, qz | d angles [rad] | vx, vy, vz, wx, wy, wz | d rates [rad/s]
//
// Height [m], orientation and velocities [m/s], [rad/s] are those of the base in the world frame;
// angles and rates those of the coordinates' representative joints. Nothing is scaled.
#pragma once

#include <Eigen/Core>

#include "plugins/robot/robot_description.h"
#include "runtime/core/module/port.h"

namespace runtime {

class State {
 public:
  static constexpr int kHeight = 0;
  static constexpr int kOrientation = 1;
  static constexpr int kAngles = 5;
  static constexpr int VelocityIndex(int dof) { return kAngles + dof; }
  static constexpr int RateIndex(int dof) { return VelocityIndex(dof) + 6; }
  static constexpr int Size(int dof) { return RateIndex(dof) + dof; }

  virtual ~State() = default;

  // The DoF configuration that the vector is made for. Throws UserError if the user named one that
  // does not exist.
  virtual const robot::DofConfiguration& dof() const = 0;

  // The vector as of now, Size(dof().dof()) elements. Only valid while an episode runs.
  virtual const Eigen::VectorXd& Read() const = 0;
};

template <>
struct TypeText<State> {
  static constexpr const char* value = "robot state";
};

}  // namespace runtime
