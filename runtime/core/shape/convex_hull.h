// The convex hull of points, as a body of uniform density.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "plugins/robot/robot_description.h"

namespace runtime {

struct HullFace {
  std::array<int, 3> corners;  // indices; counterclockwise as seen from outside
  Eigen::Vector3d normal;      // unit vector, outwards
  double distance;             // of the plane from the origin, along the normal [m]
};

// Faces are triangles; several of them may lie in one plane.
struct ConvexHull {
  std::vector<Eigen::Vector3d> corners;
  std::vector<HullFace> faces;
};

struct HullMass {
  double volume;            // [m^3]
  Eigen::Vector3d center;   // of mass
  Eigen::Matrix3d inertia;  // about the center, of a mass of 1 [m^2]
};

// By Qhull. The order of corners and faces depends on the points alone. Throws UserError where the
// points are not solid (robot::IsSolid).
ConvexHull HullOf(const std::vector<robot::Vector3>& points);

// Sums over the tetrahedra between a point inside and the faces.
HullMass MassOf(const ConvexHull& hull);

}  // namespace runtime
