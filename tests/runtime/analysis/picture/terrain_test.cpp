#include "runtime/analysis/picture/terrain.h"

#include <gtest/gtest.h>

#include <cmath>

namespace runtime {
namespace {

using Eigen::Vector3d;

Ray RayFrom(const Vector3d& origin, const Vector3d& to) {
  return {origin, (to - origin).normalized()};
}

TEST(Terrain, OfAPlaneIsMetFromAboveAlone) {
  const world::Ground flat;
  const Terrain terrain(flat);
  const auto hit = terrain.FirstHit(RayFrom({0, 0, 2}, {2, 0, 0}));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance, std::sqrt(8), 1e-12);
  EXPECT_EQ(hit->normal, Vector3d::UnitZ());
  EXPECT_FALSE(terrain.FirstHit(RayFrom({0, 0, 2}, {2, 0, 3})));
  EXPECT_FALSE(terrain.FirstHit(RayFrom({0, 0, -2}, {2, 0, 0})));
}

TEST(Terrain, OfASlopeFacesAwayFromIt) {
  const world::Ground ground{world::Slope{.angle = 0.5}};
  const Terrain terrain(ground);
  const auto hit = terrain.FirstHit(RayFrom({1, 0, 5}, {1, 0, 0}));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(5 - hit->distance, std::tan(0.5), 1e-12);
  EXPECT_LT(hit->normal.x(), 0);
  EXPECT_TRUE(terrain.Hides(RayFrom({1, 0, 5}, {1, 0, 0}), 4.9));
  EXPECT_FALSE(terrain.Hides(RayFrom({1, 0, 5}, {1, 0, 0}), 4));
}

TEST(Terrain, OfStepsHasTreadsAndRisers) {
  const world::Ground ground{world::Steps{.start = 1, .depth = 0.5, .height = 0.2, .count = 3}};
  const Terrain terrain(ground);
  const auto tread = terrain.FirstHit(RayFrom({1.7, 0, 3}, {1.7, 0, 0}));
  ASSERT_TRUE(tread);
  EXPECT_NEAR(3 - tread->distance, 0.4, 1e-12);
  const auto riser = terrain.FirstHit(RayFrom({0, 0, 0.1}, {2, 0, 0.1}));
  ASSERT_TRUE(riser);
  EXPECT_NEAR(riser->distance, 1, 1e-12);
  EXPECT_EQ(riser->normal, -Vector3d::UnitX());
}

TEST(Terrain, OfHillsIsMetWhereTheyAre) {
  world::HeightMap map{.columns = 3, .rows = 2, .size_x = 4, .size_y = 4};
  map.heights = {0, 1, 0, 0, 1, 0};
  const world::Ground ground{map};
  const Terrain terrain(ground);
  const auto hit = terrain.FirstHit(RayFrom({-1, 0, 3}, {-1, 0, 0}));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(3 - hit->distance, 0.5, 1e-5);
  EXPECT_NEAR(hit->normal.x(), -1 / std::sqrt(5), 1e-6);
  const auto beside = terrain.FirstHit(RayFrom({-5, 0, 3}, {-5, 0, 0}));
  ASSERT_TRUE(beside);
  EXPECT_NEAR(beside->distance, 3, 1e-12);
}

}  // namespace
}  // namespace runtime
