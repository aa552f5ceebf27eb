// What joints leave free, each kind a way to eliminate it from the equations of a tree
// (runtime/training/simulation/tree_factor.h).
#pragma once

#include <Eigen/Cholesky>
#include <cmath>
#include <variant>

#include "runtime/training/simulation/spatial.h"

namespace runtime {

// The unknown impulses of an elimination step, two more numbers than a body has directions.
using Part = Eigen::Matrix<double, 8, 1>;

// The way along or about one axis: a hinge's turn where kHalf is 3, a slider's shift where it is 0;
// that is where the half of a Vector6 begins in which it moves.
//
// With the inertia M at the joint, the column  u = M axis  and  d = axis' u + hold,  what is felt
// is  N = M - u u' / d.
template <int kHalf>
class FreeAxis {
 public:
  // `felt`, the inertia at the joint, becomes N; `share` becomes P N, and `held` P N P, with the
  // projection P on what is not free.
  void Eliminate(const Vector3& axis, double hold, Matrix6& felt, Matrix6& share, Matrix6& held) {
    column_.noalias() = felt.middleCols<3>(kHalf) * axis;
    inverse_ = 1 / (axis.dot(column_.segment<3>(kHalf)) + hold);
    for (int i = 0; i < 6; ++i) felt.row(i) -= inverse_ * column_[i] * column_.transpose();

    // From the column N axis.
    Vector6 column = hold * inverse_ * column_;
    share = felt;
    for (int i = 0; i < 3; ++i) share.row(kHalf + i) -= axis[i] * column.transpose();
    Remove(axis, column);
    held = share;
    for (int i = 0; i < 6; ++i) {
      held.row(i).template segment<3>(kHalf) -= column[i] * axis.transpose();
    }
  }

  // Takes what moves freely away from a force or an impulse.
  void Remove(const Vector3& axis, Vector6& force) const {
    force.template segment<3>(kHalf) -= axis.dot(force.template segment<3>(kHalf)) * axis;
  }

  // What is felt of an impulse at the joint, and of the load on the free motion.
  Vector6 PassOn(const Vector3& axis, const Vector6& impulse, const Vector6& load) {
    impulse_ = axis.dot(impulse.template segment<3>(kHalf) + load.template segment<3>(kHalf));
    return impulse - inverse_ * impulse_ * column_;
  }

  // Adds the free motion to one that has none.
  void AddMotion(const Vector3& axis, Vector6& velocity) const {
    velocity.template segment<3>(kHalf) += inverse_ * (impulse_ - column_.dot(velocity)) * axis;
  }

  void AddTo(Part& part) const { part[6] = impulse_ * std::sqrt(inverse_); }

 private:
  Vector6 column_ = Vector6::Zero();  // u
  double inverse_ = 0;                // 1 / d
  double impulse_ = 0;                // of the last solution
};

// All turns, as those of a ball. With the three columns U = M turns and D = turns' U + hold, what
// is felt is  N = M - U D^-1 U'.
class FreeTurns {
 public:
  void Eliminate(const Vector3&, double hold, Matrix6& felt, Matrix6& share, Matrix6& held) {
    columns_ = felt.rightCols<3>();
    Matrix3 turning = columns_.bottomRows<3>();
    turning.diagonal().array() += hold;
    factor_.compute(turning);
    felt.noalias() -= columns_ * factor_.solve(columns_.transpose());
    share = felt;
    share.bottomRows<3>().setZero();
    held = share;
    held.rightCols<3>().setZero();
  }
  void Remove(const Vector3&, Vector6& force) const { force.tail<3>().setZero(); }
  Vector6 PassOn(const Vector3&, const Vector6& impulse, const Vector6& load) {
    impulse_ = impulse.tail<3>() + load.tail<3>();
    return impulse - columns_ * factor_.solve(impulse_);
  }
  void AddMotion(const Vector3&, Vector6& velocity) const {
    velocity.tail<3>() += factor_.solve(impulse_ - columns_.transpose() * velocity);
  }
  // Where the half of what is held is zero.
  void AddTo(Part& part) const { part.segment<3>(3) = factor_.matrixL().solve(impulse_); }

 private:
  Eigen::Matrix<double, 6, 3> columns_ = Eigen::Matrix<double, 6, 3>::Zero();  // U
  Eigen::LLT<Eigen::Matrix3d> factor_{Eigen::Matrix3d::Identity()};            // of D
  Vector3 impulse_ = Vector3::Zero();  // of the last solution
};

class NothingFree {
 public:
  void Eliminate(const Vector3&, double, Matrix6& felt, Matrix6& share, Matrix6& held) {
    share = felt;
    held = felt;
  }
  void Remove(const Vector3&, Vector6&) const {}
  Vector6 PassOn(const Vector3&, const Vector6& impulse, const Vector6&) { return impulse; }
  void AddMotion(const Vector3&, Vector6&) const {}
  void AddTo(Part&) const {}
};

using FreeTurn = FreeAxis<3>;
using FreeShift = FreeAxis<0>;
using FreeMotion = std::variant<FreeTurn, FreeShift, FreeTurns, NothingFree>;

}  // namespace runtime
