// What happens in the course of a time step, for sensors of which a single physics step says
// little: accelerations and forces of contacts jump from one to the next.
#pragma once

#include <span>
#include <vector>

#include "runtime/training/simulation/robot_body.h"
#include "runtime/training/simulation/spatial.h"

namespace runtime {

// Means since the start of the last time step that was measured; 0 before the first.
class StepMeans {
 public:
  // What to measure: each costs something in every step.
  struct Wanted {
    bool base_acceleration = false;
    bool joint_accelerations = false;
    bool contact_forces = false;
    bool site_accelerations = false;
  };

  // `body` outlives the object.
  explicit StepMeans(const RobotBody& body);

  // A time step begins.
  void Start(const Wanted& wanted);
  // A physics step of this length [s] is over.
  void Add(double length) { elapsed_ += length; }
  // To which a physics step adds the impulses of the contacts on each body [N s]; empty where they
  // are not wanted.
  std::span<Vector3> impulses() { return impulses_; }

  // [m / s^2], of the base link's center in the world frame.
  Vector3 BaseAcceleration() const;
  double JointAcceleration(int joint) const;  // [rad / s^2]
  Vector3 ContactForce(int link) const;       // [N], in the world frame
  Vector3 SiteAcceleration(int site) const;   // [m / s^2], in the world frame

 private:
  const RobotBody& body_;
  double elapsed_ = 0;
  // At the start; empty where they are not wanted.
  std::vector<Vector3> base_velocity_;
  std::vector<double> joint_velocities_;
  std::vector<Vector3> site_velocities_;
  std::vector<Vector3> impulses_;  // since the start
};

}  // namespace runtime
