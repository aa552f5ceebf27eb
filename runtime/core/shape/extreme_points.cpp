#include "runtime/core/shape/extreme_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace runtime {
namespace {

// On a spiral that goes on by the golden angle from each to the next.
Eigen::Vector3d Direction(int index, int count) {
  constexpr double kGoldenAngle = std::numbers::pi * (3 - 2.2360679774997896964);
  const double z = 1 - (2 * index + 1.0) / count;
  const double across = std::sqrt(1 - z * z);
  return {across * std::cos(kGoldenAngle * index), across * std::sin(kGoldenAngle * index), z};
}

}  // namespace

std::vector<Eigen::Vector3d> ExtremePoints(std::span<const Eigen::Vector3d> points,
                                           int directions) {
  std::vector<Eigen::Vector3d> extreme;
  for (int i = 0; i < directions; ++i) {
    const Eigen::Vector3d direction = Direction(i, directions);
    const auto along = [&](const Eigen::Vector3d& point) { return direction.dot(point); };
    const Eigen::Vector3d& farthest = *std::ranges::max_element(points, {}, along);
    if (std::ranges::find(extreme, farthest) == extreme.end()) extreme.push_back(farthest);
  }
  return extreme;
}

}  // namespace runtime
