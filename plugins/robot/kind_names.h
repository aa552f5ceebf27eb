#pragma once

#include <cstdlib>

#include "plugins/robot/robot_description.h"

namespace robot {

// As description files call it.
inline const char* NameOf(JointKind kind) {
  switch (kind) {
    case JointKind::kHinge:
      return "hinge";
    case JointKind::kContinuous:
      return "continuous";
    case JointKind::kSlider:
      return "slider";
  }
  std::abort();
}

inline const char* NameOf(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::kBox:
      return "box";
    case ShapeKind::kCapsule:
      return "capsule";
    case ShapeKind::kCylinder:
      return "cylinder";
    case ShapeKind::kSphere:
      return "sphere";
    case ShapeKind::kConvex:
      return "convex";
  }
  std::abort();
}

}  // namespace robot
