// Linear equations of motion of bodies that joints connect to a tree, and of single ones, solved in
// a time proportional to the number of bodies.
#pragma once

#include <span>
#include <vector>

#include "runtime/training/simulation/free_motion.h"
#include "runtime/training/simulation/spatial.h"

namespace runtime {

// A joint seen as a stiff spring on the velocities of the two bodies' points that it joins, child's
// minus parent's: it pushes the child with the impulse  load - stiffness * difference,  and the
// parent with the opposite. The stiffness is `hold` in every direction but for those that the joint
// leaves free, where it is `hold_of_free`.
struct TreeJoint {
  int parent = 0;
  int child = 0;
  FreeMotion free;     // of the child
  Vector3 parent_arm;  // from the bodies' centers of mass to their ends of the joint
  Vector3 child_arm;
  Vector3 axis;  // unit vector, of what is free along or about one
  double hold = 0;
  double hold_of_free = 0;
  Vector6 load;
};

// Everything is in the world's frame, bodies are described at their centers of mass.
//
// A child is eliminated in two steps. First what its joint leaves free
// (runtime/training/simulation/free_motion.h), after which its inertia at the joint is felt as N.
// Then, in the directions P that are held, the spring: with  L D L' = hold + P N P  and
// W = L^-1 P N,  its parent feels  N - W' D^-1 W.  The two steps keep the large stiffnesses away
// from the small inertia of what is free, which would drown in their rounding.
class TreeFactor {
 public:
  // Each body but body 0 is the child of one joint. A joint comes before those whose parent is its
  // child. The parents, the children and what is free stay. Where `has_fixed_root` body 0 does not
  // move, whatever its inertia.
  // Behind the tree's bodies there are `free_bodies` more, which no joint holds.
  explicit TreeFactor(std::vector<TreeJoint> joints, bool has_fixed_root = false,
                      int free_bodies = 0);

  std::span<TreeJoint> joints() { return joints_; }
  std::span<const TreeJoint> joints() const { return joints_; }

  // Takes up the joints as they are, and the inertia of each body. Nothing here or below allocates.
  void Factorize(std::span<Matrix6> inertias);

  // From the momentum that each body would have if no joint held it to its velocity. Destroys
  // the momenta.
  void Solve(std::span<Vector6> momenta, std::span<Vector6> velocities);

  // What an impulse amounts to, body by body: the velocity along constraint a that a unit impulse
  // along constraint b brings is the sum of the scalar products of a's parts and b's.
  using Part = runtime::Part;

  // `impulses` and `parts` have one element for each body; the impulses are destroyed.
  void Decompose(std::span<Vector6> impulses, std::span<Part> parts);

 private:
  // A body that no joint holds to another.
  struct Root {
    size_t body = 0;
    Factor6 factor{};
  };
  // Of one joint's child.
  struct Elimination {
    Factor6 factor;  // L D L'
    Matrix6 share;   // W
    Vector6 half;    // of the last solution: L^-1 P (impulse at the joint + load)

    // Returns the inertia that the joint's parent feels of one at the joint.
    Matrix6 Eliminate(TreeJoint& joint, const Matrix6& inertia);
    // Returns the impulse that the joint's parent feels of one at the joint.
    Vector6 PassOn(TreeJoint& joint, const Vector6& impulse, const Vector6& load);
    // Returns the child's velocity at the joint, from its parent's.
    Vector6 Velocity(const TreeJoint& joint, const Vector6& parent) const;
  };

  std::vector<TreeJoint> joints_;
  std::vector<Elimination> eliminations_;  // of the joints' children
  bool has_fixed_root_;
  std::vector<Root> roots_;  // body 0 unless it is fixed, and the free bodies
};

}  // namespace runtime
