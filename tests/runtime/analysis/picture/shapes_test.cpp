#include "runtime/analysis/picture/shapes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plugins/robot/shape_extent.h"

namespace runtime {
namespace {

std::optional<Hit> FirstHit(const robot::LinkShape& shape, const Ray& ray) {
  return Solid(shape).FirstHit(ray);
}

using Eigen::Vector3d;
using robot::LinkShape;
using robot::ShapeKind;

const LinkShape kBall{ShapeKind::kSphere, {}, 2, 0, 0};
const LinkShape kRod{ShapeKind::kCapsule, {}, 1, 6, 2};          // straight from z = -2 to 2
const LinkShape kBrick{ShapeKind::kBox, {10, 20, 30}, 0, 0, 0};  // edges of radius 1.4

void ExpectHit(const LinkShape& shape, const Ray& ray, double distance, const Vector3d& normal) {
  const std::optional<Hit> hit = FirstHit(shape, ray);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance, distance, 1e-12);
  EXPECT_NEAR((hit->normal - normal).norm(), 0, 1e-12) << hit->normal.transpose();
}

TEST(FirstHit, MeetsABallWhereItFacesTheRay) {
  ExpectHit(kBall, {{5, 0, 0}, {-1, 0, 0}}, 3, {1, 0, 0});
  // At y = 1.2 the ball ends at x = 1.6.
  ExpectHit(kBall, {{5, 1.2, 0}, {-1, 0, 0}}, 3.4, {0.8, 0.6, 0});
  EXPECT_FALSE(FirstHit(kBall, {{5, 2.001, 0}, {-1, 0, 0}}));
}

TEST(FirstHit, IsNotBehindTheRayNorAroundIt) {
  EXPECT_FALSE(FirstHit(kBall, {{5, 0, 0}, {1, 0, 0}}));
  for (const LinkShape& shape : {kBall, kRod, kBrick}) {
    EXPECT_FALSE(FirstHit(shape, {{0, 0, 0}, {0, 0.6, 0.8}}));
  }
}

TEST(FirstHit, MeetsTheSideOfACapsule) {
  ExpectHit(kRod, {{5, 0.6, 1.9}, {-1, 0, 0}}, 4.2, {0.8, 0.6, 0});
  EXPECT_FALSE(FirstHit(kRod, {{5, 1.001, 0}, {-1, 0, 0}}));
}

TEST(FirstHit, MeetsTheCapsOfACapsule) {
  ExpectHit(kRod, {{0, 0, 5}, {0, 0, -1}}, 2, {0, 0, 1});
  ExpectHit(kRod, {{5, 0, -2.6}, {-1, 0, 0}}, 4.2, {0.8, 0, -0.6});
  EXPECT_FALSE(FirstHit(kRod, {{5, 0, 3.001}, {-1, 0, 0}}));
}

// Passes the tube where it would be if it were longer, then goes down on the cap.
TEST(FirstHit, MeetsACapOnASlant) {
  const double half = std::sqrt(0.5);
  ExpectHit(kRod, {{2, 0, 4}, {-half, 0, -half}}, std::sqrt(8.) - 1, {half, 0, half});
}

TEST(FirstHit, MeetsTheSideAndTheEndsOfACylinder) {
  const LinkShape drum{ShapeKind::kCylinder, {}, 1, 6, 2};
  ExpectHit(drum, {{5, 0.6, 2.9}, {-1, 0, 0}}, 4.2, {0.8, 0.6, 0});
  ExpectHit(drum, {{0.3, 0.5, 5}, {0, 0, -1}}, 2, {0, 0, 1});
  const double half = std::sqrt(0.5);
  ExpectHit(drum, {{-4, 0, 7}, {half, 0, -half}}, 4 / half, {0, 0, 1});
  EXPECT_FALSE(FirstHit(drum, {{5, 0, 3.001}, {-1, 0, 0}}));
  EXPECT_FALSE(FirstHit(drum, {{5, 1.001, 0}, {-1, 0, 0}}));
  EXPECT_FALSE(FirstHit(drum, {{0, 0, 0}, {0, 0.6, 0.8}}));
}

TEST(FirstHit, LiesAlongTheAxisOfTheCapsule) {
  LinkShape rod = kRod;
  rod.axis = 0;
  ExpectHit(rod, {{5, 0, 0}, {-1, 0, 0}}, 2, {1, 0, 0});
  rod.axis = 1;
  ExpectHit(rod, {{5, 0, 0}, {-1, 0, 0}}, 4, {1, 0, 0});
}

TEST(FirstHit, MeetsTheFacesOfABox) {
  ExpectHit(kBrick, {{20, 8, -13}, {-1, 0, 0}}, 15, {1, 0, 0});
  ExpectHit(kBrick, {{-20, 8, -13}, {1, 0, 0}}, 15, {-1, 0, 0});
  ExpectHit(kBrick, {{3, 8, -40}, {0, 0, 1}}, 25, {0, 0, -1});
  ExpectHit(kBrick, {{8, 1, 0}, {-0.6, 0.8, 0}}, 5, {1, 0, 0});
  EXPECT_FALSE(FirstHit(kBrick, {{20, 10.001, 0}, {-1, 0, 0}}));
}

// The edge along z is a quarter of a tube of radius 1.4 around x = 3.6, y = 8.6.
TEST(FirstHit, MeetsTheRoundEdgesOfABox) {
  ExpectHit(kBrick, {{20, 8.6 + 0.6 * 1.4, 4}, {-1, 0, 0}}, 20 - 3.6 - 0.8 * 1.4, {0.8, 0.6, 0});
  EXPECT_FALSE(FirstHit(kBrick, {{14.6, 0, 4}, {-std::sqrt(0.5), std::sqrt(0.5), 0}}));
}

TEST(FirstHit, MeetsTheRoundCornersOfABox) {
  const Vector3d out(2. / 3, 1. / 3, 2. / 3);
  ExpectHit(kBrick, {Vector3d(3.6, 8.6, 13.6) + 9 * out, -out}, 9 - 1.4, out);
}

TEST(RadiusAround, HoldsTheWholeShape) {
  EXPECT_EQ(robot::RadiusAround(kBall), 2);
  EXPECT_EQ(robot::RadiusAround(kRod), 3);
  EXPECT_DOUBLE_EQ(robot::RadiusAround(kBrick), std::sqrt(350.));
}

// An octahedron: the face between three axes has the normal (1, 1, 1) / sqrt(3).
TEST(ShapesTest, AConvexShapeIsEnteredThroughItsFaces) {
  robot::LinkShape shape;
  shape.kind = robot::ShapeKind::kConvex;
  shape.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const Eigen::Vector3d normal = Eigen::Vector3d::Ones().normalized();
  const std::optional<Hit> hit = FirstHit(shape, {3 * normal, -normal});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance, 3 - 1 / std::sqrt(3.), 1e-12);
  EXPECT_NEAR((hit->normal - normal).norm(), 0, 1e-12);
  EXPECT_FALSE(FirstHit(shape, {{3, 1.01, 0}, {-1, 0, 0}}));
  EXPECT_FALSE(FirstHit(shape, {{3, 0, 0}, {1, 0, 0}}));
  EXPECT_EQ(robot::RadiusAround(shape), 1);
}

}  // namespace
}  // namespace runtime
