// A robot that is one ball.
#pragma once

#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/analysis/behavior/motion.h"

namespace runtime {

// Of radius `radius` [m].
inline std::vector<robot::Link> Ball(double radius, const char* name = "body") {
  robot::Link link;
  link.name = name;
  link.shape.radius = radius;
  return {link};
}

// At these places, one in each frame of 0.5 s.
inline Motion MotionThrough(const std::vector<Eigen::Vector3d>& places) {
  return {0.5, 1, places,
          std::vector<Eigen::Quaterniond>(places.size(), Eigen::Quaterniond::Identity())};
}

}  // namespace runtime
