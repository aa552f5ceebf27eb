#include "runtime/core/shape/extreme_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "runtime/core/shape/convex_hull.h"

namespace runtime {
namespace {

TEST(ExtremePointsTest, TheCornersOfABoxAreFoundEachOnce) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 1000; ++i)
    points.emplace_back(0.9 * std::sin(3. * i), 1.8 * std::cos(5. * i), 0.4 * std::sin(7. * i));
  for (int corner = 0; corner < 8; ++corner)
    points.emplace_back(corner & 1 ? 1 : -1, corner & 2 ? 2 : -2, corner & 4 ? 0.5 : -0.5);
  const std::vector<Eigen::Vector3d> found = ExtremePoints(points, 64);
  EXPECT_EQ(found.size(), 8u);
  for (const Eigen::Vector3d& point : found) EXPECT_NEAR(std::abs(point.x()), 1, 1e-15);
}

// The share of a ball's volume that is left.
double LeftOfABall(int directions) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 20'000; ++i)
    points.push_back(Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized());
  std::vector<robot::Vector3> corners;
  for (const Eigen::Vector3d& p : ExtremePoints(points, directions))
    corners.push_back({p.x(), p.y(), p.z()});
  return MassOf(HullOf(corners)).volume / (4. / 3 * 3.14159265358979);
}

TEST(ExtremePointsTest, MoreDirectionsLeaveMoreOfABall) {
  const double coarse = LeftOfABall(64);
  const double fine = LeftOfABall(512);
  EXPECT_GT(coarse, 0.85);
  EXPECT_GT(fine, 0.98);
  EXPECT_LT(fine, 1);
}

}  // namespace
}  // namespace runtime
