// What moves a robot's bodies by one physics step, once its contacts and its joints' torques are
// known.
#pragma once

#include <memory>
#include <span>

#include "plugins/robot/robot_description.h"
#include "runtime/training/simulation/collision.h"
#include "runtime/training/simulation/joint_controller.h"
#include "runtime/training/simulation/profile.h"
#include "runtime/training/simulation/robot_body.h"
#include "runtime/training/simulation/spatial.h"
#include "runtime/training/simulation/surroundings.h"

namespace runtime {

class PhysicsSolver {
 public:
  virtual ~PhysicsSolver() = default;

  // One step, from the bodies' present state with what the controller drives the joints by. Adds to
  // `impulses` what the contacts do to each body [N s, in the world frame], unless it is empty:
  // that changes nothing in the step. Throws OdeFailure if it cannot be computed.
  virtual void Step(std::span<const Contact> contacts, const JointController& controller,
                    std::span<Vector3> impulses) = 0;

  // For each link 1 if it touched the ground in the last step, where the solver looks for contacts
  // by itself; else nothing, and the contacts that it was given say so.
  virtual std::span<const unsigned char> ground() const { return {}; }
  // The same of contacts with a thing.
  virtual std::span<const unsigned char> touches(size_t /*thing*/) const { return {}; }
};

// The constants of the equations that every solver solves.
struct SolverSettings {
  double time_step;   // [s]
  Softness contacts;  // of the contacts' normals
  double gravity = robot::kGravity;
  double erp = 0.2;   // of joints
  double cfm = 1e-5;  // of joints, and of what keeps contacts from sliding
  double bounce = 1e-5;
  double bounce_speed = 0.1;  // slower impacts do not bounce [m / s]
};

// All objects outlive the solver; `controller` is the one of all its steps.
std::unique_ptr<PhysicsSolver> MakeSolver(const robot::RobotDescription& robot,
                                          const Surroundings& around, const Profile& profile,
                                          const SolverSettings& settings,
                                          const JointController& controller, RobotBody& body,
                                          dWorldID world);

}  // namespace runtime
