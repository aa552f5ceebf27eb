// Friction with a limit, as a pyramid: along each of two directions at most a share of the normal's
// impulse.
#pragma once

#include <ode/ode.h>

#include <array>
#include <cmath>

#include "runtime/training/simulation/limit.h"
#include "runtime/training/simulation/spatial.h"

namespace runtime {

// The two directions, which are ODE's.
inline std::array<Vector3, 2> SlidingDirections(const Vector3& normal) {
  const dVector3 along = {normal[0], normal[1], normal[2]};
  dVector3 first;
  dVector3 second;
  dPlaneSpace(along, first, second);
  return {ToEigen(first), ToEigen(second)};
}

// Along one of them, where the normal's impulse is this; `hold` keeps from sliding what stays below
// the limit.
inline LimitedPull FrictionPull(double coefficient, double normal_impulse, double hold) {
  const double limit = coefficient * std::abs(normal_impulse);
  if (limit == 0) return {};
  return {.stiffness = hold, .low = -limit, .high = limit};
}

}  // namespace runtime
