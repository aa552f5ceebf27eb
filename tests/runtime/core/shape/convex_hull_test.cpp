#include "runtime/core/shape/convex_hull.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

using Points = std::vector<robot::Vector3>;

// The corners of a box of these half extents around a center.
Points Box(const robot::Vector3& half, const robot::Vector3& center) {
  Points points;
  for (int corner = 0; corner < 8; ++corner) {
    robot::Vector3 point = center;
    for (size_t i = 0; i < 3; ++i) point[i] += (corner >> i & 1 ? 1 : -1) * half[i];
    points.push_back(point);
  }
  return points;
}

TEST(ConvexHullTest, ABoxHasTheMassOfABox) {
  const HullMass mass = MassOf(HullOf(Box({0.1, 0.2, 0.3}, {1, 2, 3})));
  EXPECT_NEAR(mass.volume, 8 * 0.1 * 0.2 * 0.3, 1e-15);
  EXPECT_NEAR((mass.center - Eigen::Vector3d(1, 2, 3)).norm(), 0, 1e-14);
  const Eigen::Vector3d inertia((0.04 + 0.09) / 3, (0.01 + 0.09) / 3, (0.01 + 0.04) / 3);
  EXPECT_NEAR((mass.inertia - Eigen::Matrix3d(inertia.asDiagonal())).norm(), 0, 1e-13);
}

// A corner of a cube of 1: V = 1/6, center 1/4 from each face; about the corner the integral of x^2
// is 1/60, and that of xy 1/120.
TEST(ConvexHullTest, ATetrahedronHasTheMassOfOne) {
  const HullMass mass = MassOf(HullOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_NEAR(mass.volume, 1. / 6, 1e-15);
  EXPECT_NEAR((mass.center - Eigen::Vector3d::Constant(0.25)).norm(), 0, 1e-15);
  EXPECT_NEAR(mass.inertia(0, 0), 6 * 2 / 60. - 2 / 16., 1e-14);
  EXPECT_NEAR(mass.inertia(0, 1), -(6 / 120. - 1 / 16.), 1e-14);
}

TEST(ConvexHullTest, EveryPointIsBehindEveryFace) {
  Points points;
  for (int i = 0; i < 200; ++i)
    points.push_back({std::sin(3. * i), std::cos(5. * i), 0.3 * std::sin(7. * i + 1)});
  const ConvexHull hull = HullOf(points);
  for (const HullFace& face : hull.faces) {
    EXPECT_NEAR(face.normal.norm(), 1, 1e-12);
    for (const robot::Vector3& point : points)
      EXPECT_LE(face.normal.dot(Eigen::Vector3d(point.data())), face.distance + 1e-12);
  }
  // Euler's formula for triangles.
  EXPECT_EQ(hull.faces.size(), 2 * hull.corners.size() - 4);
}

TEST(ConvexHullTest, FacesTurnCounterclockwise) {
  const ConvexHull hull = HullOf(Box({1, 1, 1}, {0, 0, 0}));
  for (const HullFace& face : hull.faces) {
    const auto corner = [&](size_t i) {
      return hull.corners[static_cast<size_t>(face.corners[i])];
    };
    const Eigen::Vector3d turn = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    EXPECT_NEAR(turn.normalized().dot(face.normal), 1, 1e-12);
    EXPECT_NEAR(face.distance, 1, 1e-12);
  }
}

TEST(ConvexHullTest, WhatIsWithinIsNoCorner) {
  Points points = Box({1, 1, 1}, {0, 0, 0});
  points.push_back({0.1, 0.2, 0.3});
  points.push_back({0, 0, 1});  // on a face
  EXPECT_EQ(HullOf(points).corners.size(), 8u);
}

TEST(ConvexHullTest, WhatEnclosesNoSpaceIsRefused) {
  for (const Points& points :
       {Points{}, Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Points(10, {1, 1, 1}),
        Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.2, 0}},
        Points{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}}) {
    EXPECT_FALSE(robot::IsSolid(points));
    EXPECT_THROW(HullOf(points), UserError);
  }
}

}  // namespace
}  // namespace runtime
