#include "plugins/robot/shape_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

// In this order of operations, which the start of every episode depends on.
double ReachAlong(const LinkShape& shape, const Vector3& direction) {
  const auto along = [&](int axis) { return std::abs(direction[static_cast<size_t>(axis)]); };
  switch (shape.kind) {
    case ShapeKind::kBox:
      return (along(0) * shape.size[0] + (along(1) * shape.size[1] + along(2) * shape.size[2])) / 2;
    case ShapeKind::kCapsule:
      return along(shape.axis) * (shape.length / 2 - shape.radius) + shape.radius;
    case ShapeKind::kCylinder: {
      const double tilt = std::min(1.0, along(shape.axis));
      return tilt * shape.length / 2 + shape.radius * std::sqrt(1 - tilt * tilt);
    }
    case ShapeKind::kSphere:
      return shape.radius;
    case ShapeKind::kConvex:
      break;
  }
  double reach = -std::numeric_limits<double>::infinity();
  for (const Vector3& point : shape.points) {
    reach = std::max(reach,
                     point[0] * direction[0] + (point[1] * direction[1] + point[2] * direction[2]));
  }
  return reach;
}

}  // namespace robot
