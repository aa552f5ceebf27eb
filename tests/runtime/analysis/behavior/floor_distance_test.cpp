#include "runtime/analysis/behavior/floor_distance.h"

#include <gtest/gtest.h>

#include <numbers>

namespace runtime {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

const Quaterniond kUpright = Quaterniond::Identity();

Quaterniond TurnedAboutY(double degrees) {
  return Quaterniond(AngleAxisd(degrees * std::numbers::pi / 180, Vector3d::UnitY()));
}

TEST(LowestPoint, OfASphereIsItsRadiusBelow) {
  const robot::LinkShape sphere{robot::ShapeKind::kSphere, {}, 0.1, 0, 2};
  EXPECT_DOUBLE_EQ(LowestPoint(sphere, 0.5, TurnedAboutY(33)), 0.4);
}

TEST(LowestPoint, OfABoxIsAFaceOrAnEdge) {
  const robot::LinkShape box{robot::ShapeKind::kBox, {0.6, 1, 0.2}, 0, 0, 2};
  EXPECT_DOUBLE_EQ(LowestPoint(box, 1, kUpright), 0.9);
  EXPECT_NEAR(LowestPoint(box, 1, TurnedAboutY(90)), 0.7, 1e-12);
  EXPECT_NEAR(LowestPoint(box, 1, TurnedAboutY(45)), 1 - (0.3 + 0.1) * std::sqrt(0.5), 1e-12);
}

TEST(LowestPoint, OfACapsuleIsOneOfItsCaps) {
  const robot::LinkShape capsule{robot::ShapeKind::kCapsule, {}, 0.1, 0.6, 2};  // along z
  EXPECT_DOUBLE_EQ(LowestPoint(capsule, 1, kUpright), 0.7);
  EXPECT_NEAR(LowestPoint(capsule, 1, TurnedAboutY(90)), 0.9, 1e-12);
  EXPECT_NEAR(LowestPoint(capsule, 1, TurnedAboutY(60)), 1 - 0.1 - 0.2 * 0.5, 1e-12);
}

TEST(LowestPoint, OfACylinderIsARim) {
  const robot::LinkShape cylinder{robot::ShapeKind::kCylinder, {}, 0.1, 0.6, 2};
  EXPECT_DOUBLE_EQ(LowestPoint(cylinder, 1, kUpright), 0.7);
  EXPECT_NEAR(LowestPoint(cylinder, 1, TurnedAboutY(90)), 0.9, 1e-12);
  EXPECT_NEAR(LowestPoint(cylinder, 1, TurnedAboutY(45)), 1 - 0.4 * std::sqrt(0.5), 1e-12);
}

TEST(LowestPoint, IsThatOfTheShapeWhereItIsInTheLink) {
  robot::LinkShape box{robot::ShapeKind::kBox, {0.6, 1, 0.2}, 0, 0, 2};
  box.position = {0.5, 0, 0.3};
  EXPECT_DOUBLE_EQ(LowestPoint(box, 1, kUpright), 1.2);
  EXPECT_NEAR(LowestPoint(box, 1, TurnedAboutY(90)), 0.2, 1e-12);  // x points down
  box.orientation = {std::sqrt(0.5), 0, std::sqrt(0.5), 0};
  EXPECT_NEAR(LowestPoint(box, 1, kUpright), 1, 1e-12);
}

}  // namespace
}  // namespace runtime
