#pragma once

#include <Eigen/Geometry>

#include "plugins/robot/robot_description.h"

namespace runtime {

// The height of the lowest point of a link with this shape, whose center is at `link_height` [m].
double LowestPoint(const robot::LinkShape& shape, double link_height,
                   const Eigen::Quaterniond& orientation);

}  // namespace runtime
