// A few of many points whose convex hull is nearly that of all.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace runtime {

// The farthest points along `directions` directions, which are spread evenly over the sphere; each
// once, in the order of the directions. All corners of a body with few of them.
std::vector<Eigen::Vector3d> ExtremePoints(std::span<const Eigen::Vector3d> points, int directions);

}  // namespace runtime
