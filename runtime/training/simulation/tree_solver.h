// A physics step along the tree of a robot's links.
//
// The equations are those of ODE's dWorldStep, with the same constants: velocities v and impulses
// that satisfy, for every constraint with the Jacobian row J, the mixing cfm and the target c,
//
//   J v + cfm / h * impulse = c,  or the impulse is at its limit.
//
// So each constraint is a spring on a velocity, of the stiffness h / cfm. dWorldStep eliminates the
// velocities and is left with a dense matrix of all impulses. Here the impulses are eliminated:
// what touches the ground becomes part of its body's inertia, and the joints are eliminated from
// the leaves to the base (runtime/training/simulation/tree_factor.h), in a time proportional to the
// number of links. A thing that moves is a tree of its own. Only contacts between two links, or of
// things, remain, as a small dense system.
//
// Which impulses are at their limits is found by assuming it and correcting the assumption (block
// principal pivoting: Judice and Pires, 1994), which takes one or two rounds as a rule. The
// solution is unique, so it is ODE's up to rounding.
#pragma once

#include <memory>
#include <vector>

#include "runtime/training/simulation/joint_geometry.h"
#include "runtime/training/simulation/limit.h"
#include "runtime/training/simulation/link_contacts.h"
#include "runtime/training/simulation/link_motion.h"
#include "runtime/training/simulation/physics_solver.h"
#include "runtime/training/simulation/tree_factor.h"

namespace runtime {

class TreeSolver : public PhysicsSolver {
 public:
  // `body` outlives the solver.
  TreeSolver(const robot::RobotDescription& robot, const SolverSettings& settings,
             const JointController& controller, RobotBody& body);

  void Step(std::span<const Contact> contacts, const JointController& controller,
            std::span<Vector3> impulses) override;

 private:
  // A contact's normal with the ground.
  struct GroundContact {
    int link;
    Vector6 row;
    LimitedPull pull;

    Vector3 normal() const { return row.head<3>(); }
  };
  // What resists sliding along one direction, where that is limited.
  struct GroundFriction {
    size_t contact;  // with the ground
    double coefficient;
    Vector6 row;
    LimitedPull pull;
  };
  // What acts along the coordinate of a joint, in its units
  // (runtime/training/simulation/body_joint.h).
  struct JointForces {
    size_t branch;
    double radius;
    double low_stop;  // [rad], like the angle
    double high_stop;
    double impulse = 0;              // whatever the speed
    std::vector<LimitedPull> pulls;  // as many as the controller has
    LimitedPull stop{};
  };

  void ReadLinks();
  void ReadBranch(size_t branch);
  void ReadForces(int joint, const JointController& controller);
  LimitedPull StopPull(const JointForces& forces, double angle) const;
  void ReadContacts(std::span<const Contact> contacts);
  // One that pushes the link toward `normal`.
  void AddGroundContact(int link, const Vector3& normal, const Contact& contact);
  LimitedPull NormalPull(double depth, double speed) const;
  // The rate of the joint's coordinate.
  double SpeedOf(const JointForces& forces) const;

  void AddGroundFriction(const Vector3& arm, double coefficient);
  void SolveForVelocities();
  // Friction is limited by the normals' impulses that there are without it, as in ODE.
  void LimitFrictions();
  // Until all limits are in the states that are right.
  void FindStates();
  // With the limits in the states that they are assumed to be in.
  void SolveAsAssumed();
  // What the contacts do with the velocities that were found.
  void AddImpulses(std::span<const Contact> contacts, std::span<Vector3> impulses) const;
  Vector3 ImpulseOf(size_t contact, const Contact& geometry) const;
  // Returns how many states are wrong, and corrects all of them, or the last one only.
  int CorrectStates(bool all);

  SolverSettings settings_;
  double hold_;  // stiffness of the constraints that have no mixing of their own
  RobotBody& body_;
  std::vector<LinkInertia> link_inertias_;
  std::vector<robot::Branch> branches_;
  std::vector<std::unique_ptr<JointGeometry>> geometries_;  // of the branches

  TreeFactor tree_;
  std::vector<Vector6> loads_;  // of the branches: of the constraints that have no limits
  // Of the links, and of the things as more roots; their inertias with what keeps them from sliding
  // on the ground.
  std::vector<LinkState> links_;
  std::vector<JointForces> forces_;
  std::vector<GroundContact> ground_contacts_;
  std::vector<GroundFriction> ground_frictions_;
  LinkContacts link_contacts_;
  std::vector<Vector6> velocities_;
  std::vector<Matrix6> inertias_;  // scratch
  std::vector<Vector6> momenta_;   // scratch
  std::vector<Vector6> scratch_;
};

}  // namespace runtime
