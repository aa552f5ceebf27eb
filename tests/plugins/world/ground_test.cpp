#include "plugins/world/ground.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plugins/robot/rotation.h"

namespace world {
namespace {

TEST(Ground, OfASlopeRisesTowardItsDirection) {
  const Ground ground{Slope{.angle = 0.3, .direction = 1.2}};
  EXPECT_EQ(HeightAt(ground, 0, 0), 0);
  EXPECT_NEAR(HeightAt(ground, std::cos(1.2), std::sin(1.2)), std::tan(0.3), 1e-15);
  const Vector3 up = NormalOf(ground);
  // The turn takes what is level to the slope.
  const auto turn = robot::RotationMatrix(TurnOf(ground));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(turn[3 * i + 2], up[i], 1e-15);
}

TEST(Ground, OfStepsRisesAtEachOfThem) {
  const Ground ground{Steps{.start = 1, .depth = 0.5, .height = 0.1, .count = 3}};
  EXPECT_EQ(HeightAt(ground, 0.99, 5), 0);
  EXPECT_DOUBLE_EQ(HeightAt(ground, 1.2, 0), 0.1);
  EXPECT_DOUBLE_EQ(HeightAt(ground, 1.7, 0), 0.2);
  EXPECT_DOUBLE_EQ(HeightAt(ground, 50, 0), 0.3);
  const std::vector<Block> blocks = BlocksOf(ground);
  ASSERT_EQ(blocks.size(), 3u);
  EXPECT_DOUBLE_EQ(blocks[1].low_x, 1.5);
  EXPECT_DOUBLE_EQ(blocks[1].high_x, 2);
  EXPECT_DOUBLE_EQ(blocks[1].height, 0.2);
}

Ground Hills() {
  HeightMap map{.columns = 3, .rows = 2, .size_x = 2, .size_y = 4, .heights = {0, 1, 0, 0, 3, 0}};
  return {map};
}

TEST(Ground, OfHillsIsStraightBetweenTheirHeights) {
  EXPECT_DOUBLE_EQ(HeightAt(Hills(), 0, -2), 1);
  EXPECT_DOUBLE_EQ(HeightAt(Hills(), 0, 2), 3);
  EXPECT_DOUBLE_EQ(HeightAt(Hills(), 0, 0), 2);
  EXPECT_DOUBLE_EQ(HeightAt(Hills(), 0.5, 0), 1);
  EXPECT_DOUBLE_EQ(HeightAt(Hills(), 1.5, 0), 0);  // outside
}

TEST(PutDown, LaysAThingAboveAllThatItMayTouch) {
  Thing box{.name = "box", .shape = {.kind = robot::ShapeKind::kBox, .size = {0.4, 0.4, 0.2}}};
  PutDown({}, 1, 2, {1, 0, 0, 0}, box);
  EXPECT_EQ(box.position, (Vector3{1, 2, 0.1}));
  // It would reach into the first step.
  PutDown({Steps{.start = 1.1, .depth = 1, .height = 0.3, .count = 1}}, 1, 2, {1, 0, 0, 0}, box);
  EXPECT_DOUBLE_EQ(box.position[2], 0.4);
  PutDown(Hills(), 0, 2, {1, 0, 0, 0}, box);
  EXPECT_DOUBLE_EQ(box.position[2], 3.1);
}

TEST(PutDown, KnowsHowFarATurnedThingReachesDown) {
  Thing rod{.name = "rod",
            .shape = {.kind = robot::ShapeKind::kCylinder, .radius = 0.1, .length = 1, .axis = 2}};
  const double half = std::sqrt(0.5);
  PutDown({}, 0, 0, {half, half, 0, 0}, rod);  // lying
  EXPECT_NEAR(rod.position[2], 0.1, 1e-8);
  PutDown({}, 0, 0, {1, 0, 0, 0}, rod);  // upright
  EXPECT_NEAR(rod.position[2], 0.5, 1e-15);
}

}  // namespace
}  // namespace world
