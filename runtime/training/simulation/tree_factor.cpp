#include "runtime/training/simulation/tree_factor.h"

#include <cmath>
#include <utility>

namespace runtime {

TreeFactor::TreeFactor(std::vector<TreeJoint> joints, bool has_fixed_root, int free_bodies)
    : joints_(std::move(joints)), eliminations_(joints_.size()), has_fixed_root_(has_fixed_root) {
  if (!has_fixed_root) roots_.emplace_back();
  for (int k = 0; k < free_bodies; ++k)
    roots_.emplace_back().body = joints_.size() + 1 + static_cast<size_t>(k);
}

void TreeFactor::Factorize(std::span<Matrix6> inertias) {
  for (size_t j = joints_.size(); j-- > 0;) {
    TreeJoint& joint = joints_[j];
    const Matrix6 at_joint = InertiaAt(joint.child_arm, inertias[joint.child]);
    const Matrix6 felt = eliminations_[j].Eliminate(joint, at_joint);
    inertias[joint.parent] += InertiaAt(-joint.parent_arm, felt);
  }
  for (Root& root : roots_) root.factor = Factor6(inertias[root.body]);
}

Matrix6 TreeFactor::Elimination::Eliminate(TreeJoint& joint, const Matrix6& inertia) {
  Matrix6 felt = inertia;
  Matrix6 held;
  std::visit([&](auto& free) { free.Eliminate(joint.axis, joint.hold_of_free, felt, share, held); },
             joint.free);
  held.diagonal().array() += joint.hold;

  factor = Factor6(held);
  factor.SolveLower(share);
  for (int k = 0; k < 6; ++k) {
    const double weight = factor.inverse_diagonal()[k];
    for (int i = 0; i < 6; ++i) felt.row(i) -= weight * share(k, i) * share.row(k);
  }
  return felt;
}

void TreeFactor::Solve(std::span<Vector6> momenta, std::span<Vector6> velocities) {
  for (size_t j = joints_.size(); j-- > 0;) {
    TreeJoint& joint = joints_[j];
    const Vector6 at_joint = ForceAt(joint.child_arm, momenta[joint.child]);
    const Vector6 felt = eliminations_[j].PassOn(joint, at_joint, joint.load);
    momenta[joint.parent] += ForceAt(-joint.parent_arm, felt);
  }
  if (has_fixed_root_) velocities[0].setZero();
  for (const auto& [body, factor] : roots_) {
    factor.SolveLower(momenta[body]);
    velocities[body] = momenta[body].cwiseProduct(factor.inverse_diagonal());
    factor.SolveUpper(velocities[body]);
  }
  for (size_t j = 0; j < joints_.size(); ++j) {
    const TreeJoint& joint = joints_[j];
    const Vector6 parent = VelocityAt(joint.parent_arm, velocities[joint.parent]);
    velocities[joint.child] =
        VelocityAt(-joint.child_arm, eliminations_[j].Velocity(joint, parent));
  }
}

Vector6 TreeFactor::Elimination::PassOn(TreeJoint& joint, const Vector6& impulse,
                                        const Vector6& load) {
  Vector6 felt;
  std::visit(
      [&](auto& free) {
        felt = free.PassOn(joint.axis, impulse, load);
        half = felt + load;
        free.Remove(joint.axis, half);
      },
      joint.free);
  factor.SolveLower(half);
  const Vector6 weighted = half.cwiseProduct(factor.inverse_diagonal());
  for (int k = 0; k < 6; ++k) felt -= weighted[k] * share.row(k).transpose();
  return felt;
}

Vector6 TreeFactor::Elimination::Velocity(const TreeJoint& joint, const Vector6& parent) const {
  Vector6 velocity = half;
  velocity.noalias() -= share * parent;
  velocity.array() *= factor.inverse_diagonal().array();
  factor.SolveUpper(velocity);
  velocity += parent;
  std::visit([&](const auto& free) { free.AddMotion(joint.axis, velocity); }, joint.free);
  return velocity;
}

void TreeFactor::Decompose(std::span<Vector6> impulses, std::span<Part> parts) {
  for (size_t j = joints_.size(); j-- > 0;) {
    TreeJoint& joint = joints_[j];
    Elimination& elimination = eliminations_[j];
    Part& part = parts[joint.child];
    part.setZero();
    if (impulses[joint.child].isZero(0)) continue;
    const Vector6 at_joint = ForceAt(joint.child_arm, impulses[joint.child]);
    const Vector6 felt = elimination.PassOn(joint, at_joint, Vector6::Zero());
    impulses[joint.parent] += ForceAt(-joint.parent_arm, felt);
    part.head<6>() =
        elimination.half.cwiseProduct(elimination.factor.inverse_diagonal().cwiseSqrt());
    std::visit([&](const auto& free) { free.AddTo(part); }, joint.free);
  }
  parts[0].setZero();
  for (const auto& [body, factor] : roots_) {
    parts[body].setZero();
    if (impulses[body].isZero(0)) continue;
    factor.SolveLower(impulses[body]);
    parts[body].head<6>() = impulses[body].cwiseProduct(factor.inverse_diagonal().cwiseSqrt());
  }
}

}  // namespace runtime
