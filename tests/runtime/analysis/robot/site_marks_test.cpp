#include "runtime/analysis/robot/site_marks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace runtime {
namespace {

using Eigen::Vector3d;

// The base is turned by a quarter about z, the site by a quarter about x of its link.
TEST(SiteMarks, AreItsAxesFromWhereItIs) {
  robot::RobotDescription robot;
  robot.links = {{"base", 1, {0, 0, 0}, {}}};
  robot.sites = {{.name = "tip",
                  .link = 0,
                  .position = {1, 0, 0},
                  .orientation = {std::sqrt(0.5), std::sqrt(0.5), 0, 0}}};
  robot.poses = {{"start", {0, 0, 5}, {std::sqrt(0.5), 0, 0, std::sqrt(0.5)}, {}}};
  const std::vector<Stroke> strokes = SiteMarks(robot, LinkFrames(robot, robot.poses.front()), 10);
  ASSERT_EQ(strokes.size(), 3u);
  const Vector3d place(0, 1, 5);
  for (const Stroke& stroke : strokes) EXPECT_TRUE(stroke.from.isApprox(place));
  EXPECT_TRUE((strokes[0].to - place).isApprox(Vector3d(0, 0.4, 0)));  // x, in red
  EXPECT_TRUE((strokes[1].to - place).isApprox(Vector3d(0, 0, 0.4)));  // y
  EXPECT_TRUE((strokes[2].to - place).isApprox(Vector3d(0.4, 0, 0)));  // z
  EXPECT_EQ(strokes[0].color, 0xe03131u);
}

}  // namespace
}  // namespace runtime
