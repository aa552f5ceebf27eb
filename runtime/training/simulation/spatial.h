// Small algebra of rigid bodies: velocities, forces and inertias as vectors and matrices of six,
// the linear part first. A velocity is that of the point the body is described at; a force comes
// with its torque about that point.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace runtime {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

// From three numbers of ODE's or of a robot's description.
inline Vector3 ToEigen(const double* v) { return {v[0], v[1], v[2]}; }

inline Matrix3 CrossMatrix(const Vector3& v) {
  Matrix3 cross;
  cross << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return cross;
}

// The same motion, described at a point `arm` away.
inline Vector6 VelocityAt(const Vector3& arm, const Vector6& velocity) {
  Vector6 moved = velocity;
  moved.head<3>() += velocity.tail<3>().cross(arm);
  return moved;
}

// The same force, described at a point `arm` away.
inline Vector6 ForceAt(const Vector3& arm, const Vector6& force) {
  Vector6 moved = force;
  moved.tail<3>() -= arm.cross(force.head<3>());
  return moved;
}

// The same inertia (any symmetric matrix that turns velocities into momenta), described at a point
// `arm` away.
inline Matrix6 InertiaAt(const Vector3& arm, const Matrix6& inertia) {
  const Matrix3 cross = CrossMatrix(arm);
  const Matrix3 coupling = inertia.topRightCorner<3, 3>();
  const Matrix3 moved = coupling + inertia.topLeftCorner<3, 3>() * cross;
  Matrix6 result;
  result.topLeftCorner<3, 3>() = inertia.topLeftCorner<3, 3>();
  result.topRightCorner<3, 3>() = moved;
  result.bottomLeftCorner<3, 3>() = moved.transpose();
  result.bottomRightCorner<3, 3>() =
      inertia.bottomRightCorner<3, 3>() + coupling.transpose() * cross - cross * moved;
  return result;
}

// L D L' = a symmetric positive definite matrix; L has ones on its diagonal.
class Factor6 {
 public:
  Factor6() = default;
  explicit Factor6(Matrix6 matrix) {
    for (int k = 0; k < 6; ++k) {
      inverse_diagonal_[k] = 1 / matrix(k, k);
      for (int i = k + 1; i < 6; ++i) {
        const double factor = matrix(k, i) * inverse_diagonal_[k];
        lower_(i, k) = factor;
        matrix.row(i) -= factor * matrix.row(k);
      }
    }
  }

  const Vector6& inverse_diagonal() const { return inverse_diagonal_; }

  // right <- L^-1 right
  void SolveLower(Matrix6& right) const {
    for (int i = 1; i < 6; ++i) {
      for (int k = 0; k < i; ++k) right.row(i) -= lower_(i, k) * right.row(k);
    }
  }
  void SolveLower(Vector6& right) const {
    for (int i = 1; i < 6; ++i) {
      for (int k = 0; k < i; ++k) right[i] -= lower_(i, k) * right[k];
    }
  }
  // right <- L'^-1 right
  void SolveUpper(Vector6& right) const {
    for (int i = 4; i >= 0; --i) {
      for (int k = i + 1; k < 6; ++k) right[i] -= lower_(k, i) * right[k];
    }
  }

 private:
  Matrix6 lower_;  // below the diagonal
  Vector6 inverse_diagonal_;
};

}  // namespace runtime
