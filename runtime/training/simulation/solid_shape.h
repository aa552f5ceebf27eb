// Shapes of links and things as ODE has them.
#pragma once

#include "plugins/robot/robot_description.h"
#include "runtime/training/simulation/ode_library.h"

namespace runtime {

void ToRotation(const robot::Quaternion& quaternion, dMatrix3 rotation);

// Of uniform density, along the axes of the shape.
dMass MassOfShape(const robot::LinkShape& shape, double total);

OdeGeom GeomOf(const robot::LinkShape& shape);

// Puts a geometry that belongs to a body to its place in the body's frame.
void PlaceShape(const robot::LinkShape& shape, dGeomID geom);
// Puts one that belongs to none to its place in the world.
void FixShape(const robot::LinkShape& shape, const robot::Vector3& position,
              const robot::Quaternion& orientation, dGeomID geom);

}  // namespace runtime
