#include "plugins/robot/shape_radius.h"

#include <algorithm>
#include <cmath>

namespace robot {

double RadiusAround(const LinkShape& shape) {
  switch (shape.kind) {
    case ShapeKind::kBox:
      return std::hypot(shape.size[0], shape.size[1], shape.size[2]) / 2;
    case ShapeKind::kCapsule:
      return shape.length / 2;
    case ShapeKind::kCylinder:
      return std::hypot(shape.radius, shape.length / 2);
    case ShapeKind::kSphere:
      return shape.radius;
    case ShapeKind::kConvex:
      break;
  }
  double farthest = 0;
  for (const Vector3& point : shape.points)
    farthest = std::max(farthest, std::hypot(point[0], point[1], point[2]));
  return farthest;
}

}  // namespace robot
