#include "runtime/analysis/behavior/floor_distance.h"

#include <algorithm>
#include <cmath>

namespace runtime {

double LowestPoint(const robot::LinkShape& shape, double height,
                   const Eigen::Quaterniond& orientation) {
  const Eigen::Vector3d up = orientation.conjugate() * Eigen::Vector3d::UnitZ();  // in the link
  switch (shape.kind) {
    case robot::ShapeKind::kBox:
      return height - 0.5 * up.cwiseAbs().dot(Eigen::Vector3d(shape.size.data()));
    case robot::ShapeKind::kCapsule: {
      const double straight = std::max(0., shape.length / 2 - shape.radius);
      return height - shape.radius - straight * std::abs(up[shape.axis]);
    }
    case robot::ShapeKind::kSphere:
      break;
  }
  return height - shape.radius;
}

}  // namespace runtime
