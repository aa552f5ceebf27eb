// Where a ray first meets the shape of a link.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "plugins/robot/robot_description.h"
#include "runtime/core/shape/convex_hull.h"

namespace runtime {

struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;  // unit vector

  Eigen::Vector3d At(double distance) const { return origin + distance * direction; }
};

struct Hit {
  double distance = 0;     // along the ray [m], not negative
  Eigen::Vector3d normal;  // of the surface, outwards; unit vector
};

// A shape made ready for many rays. What it is made of outlives it.
class Solid {
 public:
  // Throws UserError where a convex shape is not solid.
  explicit Solid(const robot::LinkShape& shape);

  // The point at which `ray` enters the shape; nothing where it misses it or begins inside. The ray
  // is in the shape's own frame, whose origin is its center. Boxes have rounded edges.
  std::optional<Hit> FirstHit(const Ray& ray) const;

 private:
  const robot::LinkShape* shape_;
  ConvexHull hull_;  // of a convex shape
};

// Of the edges of a box.
double EdgeRadius(const robot::LinkShape& box);

// Of a ball around its link's center that holds the shape [m].
double BoundingRadiusOfLink(const robot::LinkShape& shape);

}  // namespace runtime
