#include "runtime/analysis/behavior/floor_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace runtime {

double LowestPoint(const robot::LinkShape& shape, double link_height,
                   const Eigen::Quaterniond& orientation) {
  const Eigen::Vector3d in_link = orientation.conjugate() * Eigen::Vector3d::UnitZ();  // upward
  const auto& [w, x, y, z] = shape.orientation;
  const Eigen::Vector3d up = Eigen::Quaterniond(w, x, y, z).conjugate() * in_link;
  const double height = link_height + in_link.dot(Eigen::Vector3d(shape.position.data()));
  switch (shape.kind) {
    case robot::ShapeKind::kBox:
      return height - 0.5 * up.cwiseAbs().dot(Eigen::Vector3d(shape.size.data()));
    case robot::ShapeKind::kCapsule: {
      const double straight = std::max(0., shape.length / 2 - shape.radius);
      return height - shape.radius - straight * std::abs(up[shape.axis]);
    }
    case robot::ShapeKind::kCylinder: {
      const double tilt = std::min(1., std::abs(up[shape.axis]));
      return height - 0.5 * shape.length * tilt - shape.radius * std::sqrt(1 - tilt * tilt);
    }
    case robot::ShapeKind::kSphere:
      return height - shape.radius;
    case robot::ShapeKind::kConvex:
      break;
  }
  double lowest = std::numeric_limits<double>::infinity();
  for (const robot::Vector3& point : shape.points)
    lowest = std::min(lowest, height + up.dot(Eigen::Vector3d(point.data())));
  return lowest;
}

}  // namespace runtime
