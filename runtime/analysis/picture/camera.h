// From where a strip's pictures are taken.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/analysis/behavior/motion.h"
#include "runtime/analysis/picture/shapes.h"

namespace runtime {

// Of square pictures.
struct Camera {
  static constexpr double kHalfWidth = 0.2125565616700221;  // tangent of half the angle: 12 degrees

  Eigen::Vector3d position;
  Eigen::Vector3d right, up, forward;  // unit vectors
  double distance = 0;                 // to what it looks at [m]

  // Through a point of the picture; (0, 0) is its lower left corner and (1, 1) the upper right one.
  Ray RayThrough(double x, double y) const;
  // The width of what the picture shows at the distance that it looks at [m].
  double view() const { return 2 * kHalfWidth * distance; }
  Eigen::Vector3d target() const { return position + distance * forward; }
};

// One for each of `frames`. All look from the same side and the same distance, and at the same
// height, so that a robot that jumps is seen to leave the ground; each has the whole robot in the
// middle, or what SubjectOf() says of it. They stand across the way that the robot goes between the
// first and the last of them, a little ahead; on the side from which +x, where robots face at
// first, is to the right.
std::vector<Camera> PlaceCameras(const Motion& motion, const std::vector<robot::Link>& links,
                                 const std::vector<int>& frames);

}  // namespace runtime
