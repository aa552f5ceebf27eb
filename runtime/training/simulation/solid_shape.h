// Shapes of links and things as ODE has them.
#pragma once

#include <span>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/core/shape/convex_hull.h"
#include "runtime/training/simulation/ode_library.h"
#include "runtime/training/simulation/spatial.h"

namespace runtime {

void ToRotation(const robot::Quaternion& quaternion, dMatrix3 rotation);

// Of uniform density, along the axes of the shape, which is not convex.
dMass MassOfShape(const robot::LinkShape& shape, double total);

// Not of a convex shape.
OdeGeom GeomOf(const robot::LinkShape& shape);

// What ODE reads of a convex shape, and does not copy: outlives what it makes.
class ConvexGeom {
 public:
  // Throws UserError where the points enclose no space.
  explicit ConvexGeom(const std::vector<robot::Vector3>& points);

  OdeGeom Make() const;
  std::span<const Vector3> corners() const { return hull_.corners; }

 private:
  ConvexHull hull_;
  // A plane for each face, and its polygon: the number of corners, then these.
  std::vector<dReal> planes_;
  std::vector<unsigned> polygons_;
};

// Puts a geometry that belongs to a body to its place in the body's frame.
void PlaceShape(const robot::LinkShape& shape, dGeomID geom);
// Puts one that belongs to none to its place in the world.
void FixShape(const robot::LinkShape& shape, const robot::Vector3& position,
              const robot::Quaternion& orientation, dGeomID geom);

}  // namespace runtime
