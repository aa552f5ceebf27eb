// How one link of a robot moves during a physics step, if nothing holds it or once it is known what
// does. As in ODE: of first order, velocities first.
#pragma once

#include "runtime/training/simulation/ode_library.h"
#include "runtime/training/simulation/spatial.h"

namespace runtime {

// What does not change.
struct LinkInertia {
  double mass;
  Vector3 principal;  // moments of inertia about the principal axes
  Matrix3 axes;       // their directions in the link's frame, as columns
  bool has_own_axes;  // these are not simply the link's own

  // The principal axes in the world, of a link with this rotation.
  Matrix3 AxesIn(const Matrix3& rotation) const {
    if (!has_own_axes) return rotation;
    return rotation * axes;
  }
};

LinkInertia InertiaOf(dBodyID body);

// From the link's frame to that of the world.
Matrix3 RotationOf(dBodyID body);

// At the start of a step, in the world's frame, described at the center of mass.
struct LinkState {
  Vector3 position;
  Matrix3 rotation;
  Vector6 velocity;
  Matrix6 inertia;
  Vector6 momentum;  // at the end of the step, without any constraint
};

LinkState ReadLink(dBodyID body, const LinkInertia& inertia, double time_step, double gravity);

// Gives the body a velocity, and moves it from `before` by it.
void MoveLink(dBodyID body, const LinkState& before, const Vector6& velocity, double time_step);

}  // namespace runtime
