#include "runtime/training/simulation/tree_factor.h"

#include <cmath>
#include <utility>

namespace runtime {
namespace {

// A torque about the axis, taken away from an impulse.
[[gnu::always_inline]] inline void RemoveTurn(const Vector3& axis, Vector6& impulse) {
  impulse.tail<3>() -= axis.dot(impulse.tail<3>()) * axis;
}

}  // namespace

TreeFactor::TreeFactor(std::vector<TreeJoint> joints)
    : joints_(std::move(joints)), eliminations_(joints_.size()) {}

void TreeFactor::Factorize(std::span<Matrix6> inertias) {
  for (size_t j = joints_.size(); j-- > 0;) {
    const TreeJoint& joint = joints_[j];
    const Matrix6 at_joint = InertiaAt(joint.child_arm, inertias[joint.child]);
    const Matrix6 felt = eliminations_[j].Eliminate(joint, at_joint);
    inertias[joint.parent] += InertiaAt(-joint.parent_arm, felt);
  }
  root_ = Factor6(inertias[0]);
}

Matrix6 TreeFactor::Elimination::Eliminate(const TreeJoint& joint, const Matrix6& inertia) {
  const Vector3& axis = joint.axis;
  turn.noalias() = inertia.rightCols<3>() * axis;
  inverse_turn = 1 / (axis.dot(turn.tail<3>()) + joint.hold_of_axis);
  Matrix6 felt = inertia;
  for (int i = 0; i < 6; ++i) felt.row(i) -= inverse_turn * turn[i] * turn.transpose();

  // P N and P N P, from the column N axis.
  Vector6 column = joint.hold_of_axis * inverse_turn * turn;
  share = felt;
  for (int i = 0; i < 3; ++i) share.row(3 + i) -= axis[i] * column.transpose();
  RemoveTurn(axis, column);
  Matrix6 held = share;
  for (int i = 0; i < 6; ++i) held.row(i).tail<3>() -= column[i] * axis.transpose();
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
    const TreeJoint& joint = joints_[j];
    const Vector6 at_joint = ForceAt(joint.child_arm, momenta[joint.child]);
    const Vector6 felt = eliminations_[j].PassOn(joint, at_joint, joint.load);
    momenta[joint.parent] += ForceAt(-joint.parent_arm, felt);
  }
  root_.SolveLower(momenta[0]);
  velocities[0] = momenta[0].cwiseProduct(root_.inverse_diagonal());
  root_.SolveUpper(velocities[0]);
  for (size_t j = 0; j < joints_.size(); ++j) {
    const TreeJoint& joint = joints_[j];
    const Vector6 parent = VelocityAt(joint.parent_arm, velocities[joint.parent]);
    velocities[joint.child] =
        VelocityAt(-joint.child_arm, eliminations_[j].Velocity(joint, parent));
  }
}

Vector6 TreeFactor::Elimination::PassOn(const TreeJoint& joint, const Vector6& impulse,
                                        const Vector6& load) {
  turn_impulse = joint.axis.dot(impulse.tail<3>() + load.tail<3>());
  Vector6 felt = impulse - inverse_turn * turn_impulse * turn;
  half = felt + load;
  RemoveTurn(joint.axis, half);
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
  velocity.tail<3>() += inverse_turn * (turn_impulse - turn.dot(velocity)) * joint.axis;
  return velocity;
}

void TreeFactor::Decompose(std::span<Vector6> impulses, std::span<Part> parts) {
  for (size_t j = joints_.size(); j-- > 0;) {
    const TreeJoint& joint = joints_[j];
    Elimination& elimination = eliminations_[j];
    Part& part = parts[joint.child];
    part.setZero();
    if (impulses[joint.child].isZero(0)) continue;
    const Vector6 at_joint = ForceAt(joint.child_arm, impulses[joint.child]);
    const Vector6 felt = elimination.PassOn(joint, at_joint, Vector6::Zero());
    impulses[joint.parent] += ForceAt(-joint.parent_arm, felt);
    part.head<6>() =
        elimination.half.cwiseProduct(elimination.factor.inverse_diagonal().cwiseSqrt());
    part[6] = elimination.turn_impulse * std::sqrt(elimination.inverse_turn);
  }
  root_.SolveLower(impulses[0]);
  parts[0].setZero();
  parts[0].head<6>() = impulses[0].cwiseProduct(root_.inverse_diagonal().cwiseSqrt());
}

}  // namespace runtime
