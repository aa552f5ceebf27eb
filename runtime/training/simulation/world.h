// One episode's physics: a robot in its surroundings.
#pragma once

#include <memory>
#include <span>

#include "plugins/robot/robot_description.h"
#include "plugins/robot/start_state.h"
#include "runtime/training/simulation/collision.h"
#include "runtime/training/simulation/contact_filter.h"
#include "runtime/training/simulation/joint_controller.h"
#include "runtime/training/simulation/ode_library.h"
#include "runtime/training/simulation/physics_solver.h"
#include "runtime/training/simulation/profile.h"
#include "runtime/training/simulation/robot_body.h"
#include "runtime/training/simulation/soundness.h"
#include "runtime/training/simulation/step_means.h"
#include "runtime/training/simulation/surroundings.h"

namespace runtime {

// Two worlds made alike and stepped alike have the same bits. A world that was stepped has a past
// in ODE's caches and orders, so every episode gets a new one.
class World {
 public:
  // The robot rests in the pose, or is in this state. `around`: null where there is nothing but
  // flat ground. `robot` and `around` outlive the world.
  World(const robot::RobotDescription& robot, const Profile& profile, const robot::Pose& pose,
        const world::WorldDescription* around = nullptr)
      : World(robot, profile, robot::RestIn(pose), around) {}
  World(const robot::RobotDescription& robot, const Profile& profile,
        const robot::StartState& start, const world::WorldDescription* around = nullptr);

  World(const World&) = delete;
  World& operator=(const World&) = delete;

  double physics_time_step() const { return settings_.time_step; }  // [s]
  int physics_steps_per_time_step() const { return physics_steps_per_time_step_; }

  // A time step begins, of which the sensors will tell these means.
  void StartTimeStep(const StepMeans::Wanted& wanted) { means_.Start(wanted); }
  // One physics step toward `targets`, one angle for each joint [rad]. Throws OdeFailure if there
  // is no sensible state to continue from; the world must not be stepped again then.
  void Step(std::span<const double> targets);

  // Adds to the velocity of all links at once.
  void Push(const Vector3& velocity);

  const RobotBody& body() const { return body_; }
  const Collision& collision() const { return collision_; }
  const JointController& controller() const { return controller_; }
  const ContactFilter& contacts() const { return contact_filter_; }
  const Surroundings& surroundings() const { return surroundings_; }
  // Which links touch a thing, filtered like contacts with the ground.
  const ContactFilter& contacts_with(size_t thing) const { return thing_contacts_[thing]; }
  const StepMeans& means() const { return means_; }

 private:
  void PutOnGround(const robot::RobotDescription& robot, const robot::StartState& start);
  double DepthInGround() const;

  int physics_steps_per_time_step_;
  SolverSettings settings_;
  OdeThreading threading_;
  OdeWorld world_;
  RobotBody body_;
  Surroundings surroundings_;
  Collision collision_;
  JointController controller_;
  Soundness soundness_;
  ContactFilter contact_filter_;
  std::vector<ContactFilter> thing_contacts_;
  StepMeans means_;
  std::unique_ptr<PhysicsSolver> solver_;
};

}  // namespace runtime
