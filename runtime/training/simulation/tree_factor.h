// Linear equations of motion of bodies that joints connect to a tree, solved in a time proportional
// to the number of bodies.
#pragma once

#include <span>
#include <vector>

#include "runtime/training/simulation/spatial.h"

namespace runtime {

// A joint seen as a stiff spring on the velocities of the two bodies' points that it joins, child's
// minus parent's: it pushes the child with the impulse  load - stiffness * difference,  and the
// parent with the opposite. The stiffness is `hold` in every direction but for turns about the
// axis, where it is `hold_of_axis`.
struct TreeJoint {
  int parent = 0;
  int child = 0;
  Vector3 parent_arm;  // from the bodies' centers of mass to their ends of the joint
  Vector3 child_arm;
  Vector3 axis;  // unit vector
  double hold = 0;
  double hold_of_axis = 0;
  Vector6 load;
};

// Everything is in the world's frame, bodies are described at their centers of mass.
//
// A child is eliminated in two steps. First its turn about the joint's axis: with its inertia M at
// the joint, the column  u = M axis  and  d = axis' u + hold_of_axis,  what is felt of it is
// N = M - u u' / d.  Then, in the directions P that are held, the spring: with
// L D L' = hold + P N P  and  W = L^-1 P N,  its parent feels  N - W' D^-1 W.  The two steps keep
// the large stiffnesses away from the small inertia about the axis, which would drown in their
// rounding.
class TreeFactor {
 public:
  // Each body but body 0 is the child of one joint. A joint comes before those whose parent is its
  // child. The parents and children stay.
  explicit TreeFactor(std::vector<TreeJoint> joints);

  std::span<TreeJoint> joints() { return joints_; }
  std::span<const TreeJoint> joints() const { return joints_; }

  // Takes up the joints as they are, and the inertia of each body. Nothing here or below allocates.
  void Factorize(std::span<Matrix6> inertias);

  // From the momentum that each body would have if no joint held it to its velocity. Destroys
  // the momenta.
  void Solve(std::span<Vector6> momenta, std::span<Vector6> velocities);

  // What an impulse amounts to, body by body: the velocity along constraint a that a unit impulse
  // along constraint b brings is the sum of the scalar products of a's parts and b's.
  using Part = Eigen::Matrix<double, 8, 1>;

  // `impulses` and `parts` have one element for each body; the impulses are destroyed.
  void Decompose(std::span<Vector6> impulses, std::span<Part> parts);

 private:
  // Of one joint's child.
  struct Elimination {
    Vector6 turn;         // u
    double inverse_turn;  // 1 / d
    Factor6 factor;       // L D L'
    Matrix6 share;        // W

    // Of the last solution:
    double turn_impulse;  // about the axis
    Vector6 half;         // L^-1 P (impulse at the joint + load)

    // Returns the inertia that the joint's parent feels of one at the joint.
    Matrix6 Eliminate(const TreeJoint& joint, const Matrix6& inertia);
    // Returns the impulse that the joint's parent feels of one at the joint.
    Vector6 PassOn(const TreeJoint& joint, const Vector6& impulse, const Vector6& load);
    // Returns the child's velocity at the joint, from its parent's.
    Vector6 Velocity(const TreeJoint& joint, const Vector6& parent) const;
  };

  std::vector<TreeJoint> joints_;
  std::vector<Elimination> eliminations_;  // of the joints' children
  Factor6 root_;
};

}  // namespace runtime
