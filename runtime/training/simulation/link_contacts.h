// Contacts between two links of a robot, which close loops in the tree of its joints, or between
// things and links.
#pragma once

#include <span>
#include <vector>

#include "runtime/training/simulation/collision.h"
#include "runtime/training/simulation/limit.h"
#include "runtime/training/simulation/tree_factor.h"

namespace runtime {

class LinkContacts {
 public:
  explicit LinkContacts(int links);

  void Clear() {
    contacts_.clear();
    has_frictions_ = false;
  }
  // Between two links with these centers of mass; sliding is resisted with the stiffness `hold`,
  // where that is limited from LimitFrictions() on. Returns the pull of the normal, which is yet to
  // be set.
  LimitedPull& Add(const Contact& contact, const Vector3& first_center,
                   const Vector3& second_center, double hold);

  bool empty() const { return contacts_.empty(); }
  int size() const { return static_cast<int>(contacts_.size()); }
  bool has_frictions() const { return has_frictions_; }
  // Those that have limits: of the normal, and of the two directions of sliding where these have.
  std::span<LimitedPull> limited_pulls(int contact) {
    LinkContact& touch = contacts_[contact];
    return {touch.pulls, touch.friction < robot::kUnlimited ? size_t{3} : size_t{1}};
  }
  // Along the normal (0) or a direction of sliding (1, 2).
  double Speed(int contact, size_t row, std::span<const Vector6> velocities) const;
  // Frictions from the normals' impulses at these velocities.
  void LimitFrictions(std::span<const Vector6> velocities);
  // What is at its limit.
  void AddLimitedImpulses(std::span<Vector6> momenta) const;
  // On the first of the two links, once the velocities are known.
  Vector3 Impulse(int contact, std::span<const Vector6> velocities) const;

  // Finds the contacts' impulses, with the normals in the states that they are assumed to be in,
  // and adds them to the momenta. `velocities` are those without the contacts.
  void AddImpulses(TreeFactor& tree, std::span<const Vector6> velocities,
                   std::span<Vector6> momenta);

 private:
  // A direction in which the contact resists: what one link does, and what the other does.
  struct Row {
    int first;
    int second;
    Vector6 first_row;
    Vector6 second_row;

    double Speed(std::span<const Vector6> velocities) const {
      return first_row.dot(velocities[first]) + second_row.dot(velocities[second]);
    }
  };
  struct LinkContact {
    Row rows[3];  // the normal first
    LimitedPull pulls[3];
    double friction;  // coefficient
    double hold;
  };
  struct ActiveRow {
    const Row* row;
    double hold;
    double load;
  };

  void CollectRows();
  std::span<TreeFactor::Part> PartsOf(size_t row) { return {&parts_[row * links_], links_}; }
  void Assemble(TreeFactor& tree, std::span<const Vector6> velocities);

  size_t links_;
  std::vector<LinkContact> contacts_;
  bool has_frictions_ = false;
  std::vector<ActiveRow> active_;
  std::vector<Vector6> impulses_;        // scratch
  std::vector<TreeFactor::Part> parts_;  // of each active row, for each link
  std::vector<double> matrix_;
  std::vector<double> right_;
};

}  // namespace runtime
