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
// number of links. Only contacts between two links remain, as a small dense system.
//
// Which impulses are at their limits is found by assuming it and correcting the assumption (block
// principal pivoting: Judice and Pires, 1994), which takes one or two rounds as a rule. The
// solution is unique, so it is ODE's up to rounding.
#pragma once

#include <vector>

#include "runtime/training/simulation/limit.h"
#include "runtime/training/simulation/link_contacts.h"
#include "runtime/training/simulation/link_motion.h"
#include "runtime/training/simulation/physics_solver.h"
#include "runtime/training/simulation/tree_factor.h"

namespace runtime {

class TreeSolver : public PhysicsSolver {
 public:
  // `body` outlives the solver.
  TreeSolver(const robot::RobotDescription& robot, const Profile& profile,
             const SolverSettings& settings, RobotBody& body);

  void Step(std::span<const Contact> contacts, const JointController& controller,
            std::span<Vector3> impulses) override;

 private:
  // What does not change of a hinge, in the frames of its links.
  struct Hinge {
    Vector3 parent_anchor;
    Vector3 child_anchor;
    Vector3 axis;
    double low_stop;
    double high_stop;
  };

  // A contact's normal with the ground.
  struct GroundContact {
    int link;
    Vector6 row;
    LimitedPull pull;

    Vector3 normal() const { return row.head<3>(); }
  };
  struct HingeLimits {
    Vector6 load;       // of the constraints that have no limits
    double torque = 0;  // impulse about the axis
    LimitedPull motor;
    LimitedPull stop;
  };

  void ReadLinks();
  void ReadHinge(int hinge, const JointController& controller);
  void ReadContacts(std::span<const Contact> contacts);
  // One that pushes the link toward `normal`.
  void AddGroundContact(int link, const Vector3& normal, const dContactGeom& geometry);
  LimitedPull NormalPull(double depth, double speed) const;
  // The rate of the hinge's angle [rad / s].
  double HingeSpeed(int hinge) const;

  void SolveForVelocities();
  // With the limits in the states that they are assumed to be in.
  void SolveAsAssumed();
  // What the contacts do with the velocities that were found.
  void AddImpulses(std::span<const Contact> contacts, std::span<Vector3> impulses) const;
  Vector3 ImpulseOf(const GroundContact& contact, const Vector3& point) const;
  // Returns how many states are wrong, and corrects all of them, or the last one only.
  int CorrectStates(bool all);

  SolverSettings settings_;
  JointDrive drive_;
  double hold_;  // stiffness of the constraints that have no mixing of their own
  RobotBody& body_;
  std::vector<LinkInertia> link_inertias_;
  std::vector<Hinge> hinges_;

  TreeFactor tree_;
  std::vector<LinkState> links_;  // their inertias with what keeps them from sliding on the ground
  std::vector<HingeLimits> limits_;
  std::vector<GroundContact> ground_contacts_;
  LinkContacts link_contacts_;
  std::vector<Vector6> velocities_;
  std::vector<Matrix6> inertias_;  // scratch
  std::vector<Vector6> momenta_;   // scratch
  std::vector<Vector6> scratch_;
};

}  // namespace runtime
