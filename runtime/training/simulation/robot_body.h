// A robot's links and hinges in an ODE world.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "plugins/robot/start_state.h"
#include "runtime/training/simulation/ode_library.h"

namespace runtime {

// Masses, inertias, shapes and hinges are made in the zero pose, where the hinges' angles are 0,
// and then moved into a pose. Each body's frame is its link's frame
// (runtime/training/simulation/link_frames.h).
class RobotBody {
 public:
  // `world` outlives the body.
  RobotBody(const robot::RobotDescription& robot, const robot::StartState& start, dWorldID world);

  int link_count() const { return static_cast<int>(bodies_.size()); }
  int joint_count() const { return static_cast<int>(hinges_.size()); }
  dBodyID body(int link) const { return bodies_[link].get(); }
  dGeomID geom(int link) const { return geoms_[link].get(); }
  dJointID hinge(int joint) const { return hinges_[joint].get(); }

  // [rad]. A hinge with a stop near half a turn may give way beyond that; its angle then goes on,
  // and is not that of the other side as ODE has it.
  double JointAngle(int joint) const;

  // False if a link is too fast to be the work of the robot's motors, or its speed is not a number.
  bool IsPlausible() const;

 private:
  void AddLink(const robot::Link& link, dWorldID world);
  void AddHinge(const robot::Joint& joint, dWorldID world);
  void MoveTo(const robot::RobotDescription& robot, const robot::Pose& pose);
  Eigen::Vector3d PositionOf(int link) const;
  void SetVelocities(const robot::RobotDescription& robot, const robot::StartState& start);

  std::vector<OdeBody> bodies_;
  std::vector<OdeGeom> geoms_;
  std::vector<OdeJoint> hinges_;
  std::vector<double> middles_;  // of the hinges' stops [rad]
};

}  // namespace runtime
