#include "plugins/robot/shape_radius.h"

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
      break;
  }
  return shape.radius;
}

}  // namespace robot
