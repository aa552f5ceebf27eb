// A physics step by ODE's dWorldStep.
#pragma once

#include <vector>

#include "runtime/training/simulation/physics_solver.h"

namespace runtime {

class OdeSolver : public PhysicsSolver {
 public:
  // All objects outlive the solver; the world has its constants already.
  OdeSolver(const robot::RobotDescription& robot, const SolverSettings& settings,
            const JointController& controller, const RobotBody& body, dWorldID world);

  void Step(std::span<const Contact> contacts, const JointController& controller,
            std::span<Vector3> impulses) override;

 private:
  void Drive(const JointController& controller);
  void MoveStops(const JointController& controller);
  void MakeContacts(std::span<const Contact> contacts, bool has_feedback);
  void AddImpulses(std::span<const Contact> contacts, std::span<Vector3> impulses) const;
  dBodyID BodyOf(int link) const;

  const RobotBody& body_;
  dWorldID world_;
  double time_step_;
  const std::vector<robot::Joint>& joints_;
  std::vector<double> turns_;                 // by which each joint's stops are moved now [rad]
  std::vector<std::vector<OdeJoint>> pulls_;  // of each joint, those of the controller
  OdeJointGroup contacts_;
  dContact contact_;                      // with the surface that all have
  std::vector<dJointFeedback> feedback_;  // of each contact, where it is wanted
};

}  // namespace runtime
