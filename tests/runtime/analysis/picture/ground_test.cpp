#include "runtime/analysis/picture/ground.h"

#include <gtest/gtest.h>

#include "tests/runtime/analysis/picture/standing_ball.h"

namespace runtime {
namespace {

// Looks at the floor's point (0, 0); shows 1 m there.
Camera OverTheMiddle() {
  Camera camera;
  camera.distance = 0.5 / Camera::kHalfWidth;
  camera.forward = -Eigen::Vector3d::UnitZ();
  camera.position = camera.distance * Eigen::Vector3d::UnitZ();
  return camera;
}

constexpr double kPixel = 1e-3;  // [m]

double CoverAt(const Ground& ground, const Point& place, double pixel = kPixel) {
  return ground.Look(place, {pixel, 0}, {0, pixel}).cover;
}

TEST(Ground, HasStrongerLinesEachHalfMeter) {
  const Ground ground(OverTheMiddle(), {});
  const double plain = CoverAt(ground, {0.05, 0.05});
  const double fine = CoverAt(ground, {-0.1, 0.05});
  const double coarse = CoverAt(ground, {0.05, 0});
  EXPECT_GT(fine, plain + 0.05);
  EXPECT_GT(coarse, fine + 0.05);
  EXPECT_EQ(CoverAt(ground, {0, 0.05}), coarse);
}

TEST(Ground, FadesToNothing) {
  const Ground ground(OverTheMiddle(), {});
  EXPECT_EQ(ground.Presence({0, 0}), 1);
  EXPECT_GT(ground.Presence({0.2, 0}), ground.Presence({0, 0.4}));
  EXPECT_EQ(ground.Presence({0.4, 0.4}), 0);
  EXPECT_EQ(CoverAt(ground, {0.5, 0.5}), 0);
}

// A pixel that is as wide as all is between two lines holds the mean of everything there.
TEST(Ground, BlursLinesIntoTheirMean) {
  const Ground ground(OverTheMiddle(), {});
  const double mean = CoverAt(ground, {0.02, 0.02}, 0.5);
  EXPECT_NEAR(CoverAt(ground, {-0.02, 0.02}, 0.5), mean, 1e-12);
  EXPECT_LT(mean, CoverAt(ground, {0.02, 0}));
}

TEST(Ground, ShowsTheTrail) {
  const Trail trail = {{{-0.25, 0.05}, {0.25, 0.05}}, {{-0.25, 0.05}}};
  const Ground ground(OverTheMiddle(), trail);
  const double plain = CoverAt(Ground(OverTheMiddle(), {}), {0.05, 0.05});
  EXPECT_GT(CoverAt(ground, {0.05, 0.05}), plain + 0.5);
  EXPECT_EQ(CoverAt(ground, {0.05, 0.06}), CoverAt(Ground(OverTheMiddle(), {}), {0.05, 0.06}));
  EXPECT_GT(CoverAt(ground, {-0.25, 0.062}), CoverAt(ground, {0.25, 0.062}) + 0.1);  // the dot
}

TEST(TrailOf, EndsAtTheFrame) {
  const Motion motion = MotionThrough({{0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {3, 6, 1}, {4, 0, 1}});
  const Trail trail = TrailOf(motion, 0, {0, 2, 4}, 1);
  ASSERT_EQ(trail.points.size(), 3u);
  EXPECT_EQ(trail.points[0], Point(0, 0));
  EXPECT_EQ(trail.points[1], Point(1, 0));
  EXPECT_EQ(trail.points[2], Point(2, 2));  // of three frames, 0.5 s apart
  ASSERT_EQ(trail.marks.size(), 2u);
  EXPECT_EQ(trail.marks[1], trail.points[2]);
}

}  // namespace
}  // namespace runtime
