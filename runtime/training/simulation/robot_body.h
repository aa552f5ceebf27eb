// A robot's links, joints and sites in an ODE world, and what else moves there.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "plugins/robot/start_state.h"
#include "runtime/training/simulation/body_joint.h"
#include "runtime/training/simulation/body_site.h"
#include "runtime/training/simulation/ode_library.h"
#include "runtime/training/simulation/solid_shape.h"

namespace runtime {

// Masses, inertias, shapes and joints are made in the zero pose, where the joints' angles are 0,
// and then moved into a pose. Each body's frame is its link's frame
// (runtime/training/simulation/link_frames.h).
class RobotBody {
 public:
  // `world` outlives the body.
  RobotBody(const robot::RobotDescription& robot, const robot::StartState& start, dWorldID world);

  int link_count() const { return link_count_; }
  // Of the links, and after them of all things that can move.
  int body_count() const { return static_cast<int>(bodies_.size()); }
  int joint_count() const { return static_cast<int>(joints_.size()); }
  dBodyID body(int index) const { return bodies_[index].get(); }
  dGeomID geom(int index) const { return geoms_[index].get(); }
  // Of a convex link, in the frame of its shape; of others nothing.
  std::span<const Vector3> corners(int link) const;
  BodyJoint& joint(int joint) const { return *joints_[joint]; }
  const std::vector<BodySite>& sites() const { return sites_; }

  // A thing of the world that moves by the same physics, in the place where it is.
  void AddThing(OdeBody body, OdeGeom geom);
  // Moves all links up.
  void Lift(double height);

  // [rad]. A hinge with a stop near half a turn may give way beyond that; its angle then goes on,
  // and is not that of the other side as ODE has it. So does that of a joint that can turn further.
  double JointAngle(int joint) const;
  // Remembers how far joints have turned. To be called after every step.
  void CountTurns();

  // False if a link or a thing is too fast to be the work of the robot's motors, or its speed is
  // not a number.
  bool IsPlausible() const;

 private:
  void AddLink(const robot::Link& link, dWorldID world);
  void MoveTo(const robot::RobotDescription& robot, const robot::Pose& pose);
  Vector3 PositionOf(int link) const;
  void SetReferences(const robot::RobotDescription& robot, const robot::Pose& pose);
  void SetVelocities(const robot::RobotDescription& robot, const robot::StartState& start);

  int link_count_ = 0;
  std::vector<OdeBody> bodies_;
  std::vector<std::unique_ptr<ConvexGeom>> convex_;  // for each link that is convex
  std::vector<OdeGeom> geoms_;
  std::vector<std::unique_ptr<BodyJoint>> joints_;
  std::vector<BodyMount> mounts_;
  std::vector<BodySite> sites_;
  // An angle that each joint is within half a turn of [rad]: the middle of its stops, where these
  // are no further apart, or else its last one.
  std::vector<double> references_;
  std::vector<int> turning_;  // joints whose reference is the last angle
};

}  // namespace runtime
