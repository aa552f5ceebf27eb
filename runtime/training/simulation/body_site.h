// A robot's site in an ODE world.
#pragma once

#include "plugins/robot/robot_description.h"
#include "runtime/training/simulation/ode_library.h"
#include "runtime/training/simulation/spatial.h"

namespace runtime {

// Where the site is and how it moves, from the motion of the link that carries it.
class BodySite {
 public:
  // `link`: the body of the site's link, which outlives this.
  BodySite(const robot::RobotDescription& robot, const robot::Site& site, dBodyID link);

  // All in the world's frame.
  Vector3 Position() const;                // [m]
  Eigen::Quaterniond Orientation() const;  // site -> world
  Vector3 Velocity() const;                // [m/s]
  Vector3 AngularVelocity() const;         // [rad/s]

 private:
  Vector3 Arm() const;  // from the link's center, in the world

  dBodyID link_;
  Vector3 arm_;                     // the same in the link's frame
  Eigen::Quaterniond orientation_;  // site -> link
};

}  // namespace runtime
