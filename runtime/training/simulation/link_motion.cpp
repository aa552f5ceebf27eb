#include "runtime/training/simulation/link_motion.h"

#include <Eigen/Eigenvalues>

namespace runtime {
namespace {

// The angular velocity after a time of free rotation, to first order and implicitly, as ODE has it:
// (I - h [L]x) w = L  with the angular momentum L; in the frame of the principal axes.
Vector3 FreeRotation(const Vector3& inertia, const Vector3& angular_velocity, double time) {
  const Vector3 momentum = inertia.cwiseProduct(angular_velocity);
  Matrix3 matrix = -time * CrossMatrix(momentum);
  matrix.diagonal() += inertia;
  const Vector3 columns[] = {matrix.col(0), matrix.col(1), matrix.col(2)};
  const Vector3 cross = columns[1].cross(columns[2]);
  const double determinant = columns[0].dot(cross);
  return Vector3(momentum.dot(cross), momentum.dot(columns[2].cross(columns[0])),
                 momentum.dot(columns[0].cross(columns[1]))) /
         determinant;
}

}  // namespace

LinkInertia InertiaOf(dBodyID body) {
  dMass mass;
  dBodyGetMass(body, &mass);
  const bool has_own_axes = mass.I[1] != 0 || mass.I[2] != 0 || mass.I[6] != 0;
  if (!has_own_axes) {
    return {mass.mass, {mass.I[0], mass.I[5], mass.I[10]}, Matrix3::Identity(), false};
  }
  Matrix3 inertia;
  inertia << mass.I[0], mass.I[1], mass.I[2], mass.I[1], mass.I[5], mass.I[6], mass.I[2], mass.I[6],
      mass.I[10];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
  Matrix3 axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);  // a rotation, no reflection
  return {mass.mass, solver.eigenvalues(), axes, true};
}

Matrix3 RotationOf(dBodyID body) {
  const dReal* elements = dBodyGetRotation(body);  // rows of four
  Matrix3 rotation;
  for (int row = 0; row < 3; ++row) rotation.row(row) = ToEigen(elements + 4 * row).transpose();
  return rotation;
}

LinkState ReadLink(dBodyID body, const LinkInertia& inertia, double time_step, double gravity) {
  LinkState state;
  state.position = ToEigen(dBodyGetPosition(body));
  state.rotation = RotationOf(body);
  const Vector3 velocity = ToEigen(dBodyGetLinearVel(body));
  const Vector3 turning = ToEigen(dBodyGetAngularVel(body));
  state.velocity << velocity, turning;

  state.inertia.setZero();
  state.inertia.topLeftCorner<3, 3>().diagonal().setConstant(inertia.mass);
  const Matrix3 axes = inertia.AxesIn(state.rotation);
  state.inertia.bottomRightCorner<3, 3>() =
      axes * inertia.principal.asDiagonal() * axes.transpose();

  const Vector3 free = FreeRotation(inertia.principal, axes.transpose() * turning, time_step);
  state.momentum.head<3>() = inertia.mass * (velocity - Vector3(0, 0, time_step * gravity));
  state.momentum.tail<3>() = axes * inertia.principal.cwiseProduct(free);
  return state;
}

void MoveLink(dBodyID body, const LinkState& before, const Vector6& velocity, double time_step) {
  const Vector3 turning = velocity.tail<3>();
  dBodySetLinearVel(body, velocity[0], velocity[1], velocity[2]);
  dBodySetAngularVel(body, turning[0], turning[1], turning[2]);
  const Vector3 position = before.position + time_step * velocity.head<3>();
  dBodySetPosition(body, position[0], position[1], position[2]);
  const dReal* now = dBodyGetQuaternion(body);
  const double scalar = now[0];
  const Vector3 vector = ToEigen(now + 1);
  const Vector3 turned = vector + time_step / 2 * (scalar * turning + turning.cross(vector));
  const dQuaternion next = {scalar - time_step / 2 * turning.dot(vector), turned[0], turned[1],
                            turned[2]};
  dBodySetQuaternion(body, next);  // which makes it a unit quaternion
}

}  // namespace runtime
