// Where a convex shape touches the ground.
#pragma once

#include <ode/ode.h>

#include <span>

#include "runtime/training/simulation/spatial.h"

namespace runtime {

// The corners of `convex` below the plane. Of more than there is room for in `found`: the deepest,
// then again and again the one that is farthest from those before, so that what lies flat is held
// where it is widest. (ODE itself takes the first that it finds.) Returns how many.
int CornersBelow(dGeomID plane, dGeomID convex, std::span<const Vector3> corners,
                 std::span<dContactGeom> found);

}  // namespace runtime
