#include "runtime/analysis/picture/render.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/runtime/analysis/picture/standing_ball.h"

namespace runtime {
namespace {

using Eigen::Vector3d;

constexpr int kSize = 200;

Image Draw(const std::vector<robot::Link>& links, const Motion& motion, const Camera& camera) {
  Image image(kSize, kSize);
  const PosedRobot robot(links, motion, 0);
  const world::Ground flat;
  const Terrain terrain(flat);
  const std::vector<Paint> paints = PaintsOf(links);
  Render({links, paints, robot, terrain, Ground(camera, {}), camera}, 0, kSize, image);
  return image;
}

// Looks along +y from ten meters before `target`.
Camera LevelCamera(const Vector3d& target) {
  return {target - 10 * Vector3d::UnitY(), Vector3d::UnitX(), Vector3d::UnitZ(), Vector3d::UnitY(),
          10};
}

// Of all pixels, in pixels.
double CoverOf(const Image& image) {
  double sum = 0;
  for (int i = 0; i < kSize * kSize; ++i) sum += image.pixel(i % kSize, i / kSize)[3] / 255.;
  return sum;
}

// So high up that no floor is to be seen. A ball of 1 m, seen from 10 m, ends where a ray touches
// it: at a tangent of 1 / sqrt(10^2 - 1).
TEST(Render, DrawsABallAsLargeAsItLooks) {
  const Vector3d place(0, 0, 1000);
  const Image image = Draw(Ball(1), MotionThrough({place}), LevelCamera(place));
  const double radius = kSize / 2 * (1 / std::sqrt(99.)) / Camera::kHalfWidth;
  EXPECT_NEAR(CoverOf(image), M_PI * radius * radius, 0.003 * M_PI * radius * radius);
  EXPECT_EQ(image.pixel(kSize / 2, kSize / 2)[3], 255);
  EXPECT_EQ(image.pixel(1, 1)[3], 0);
}

TEST(Render, TellsLeftFromRight) {
  const Vector3d place(0, 0, 1000);
  const auto middle = [&](const char* name) {
    const Image image = Draw(Ball(1, name), MotionThrough({place}), LevelCamera(place));
    const uint8_t* pixel = image.pixel(kSize / 2, kSize / 2);
    return pixel[2] - pixel[0];  // how much more blue than red
  };
  EXPECT_GT(middle("left_hand"), 40);
  EXPECT_LT(middle("right_hand"), -40);
  EXPECT_NEAR(middle("body"), 0, 20);
}

TEST(Render, IsLitFromTheUpperLeft) {
  const Vector3d place(0, 0, 1000);
  const Image image = Draw(Ball(1), MotionThrough({place}), LevelCamera(place));
  const int off = kSize / 8;
  EXPECT_GT(image.pixel(kSize / 2 - off, kSize / 2 - off)[0],
            image.pixel(kSize / 2 + off, kSize / 2 + off)[0] + 30);
}

// On a floor without lines: those are at multiples of 10 cm.
TEST(Render, CastsAShadowAwayFromTheLamp) {
  const Motion motion = MotionThrough({{0, 0, 0.12}});
  const std::vector<robot::Link> links = Ball(0.05);
  Camera camera = PlaceCameras(motion, links, {0}).front();
  camera.position -= camera.forward;  // to have more of the floor in the picture
  camera.distance += 1;
  const Image image = Draw(links, motion, camera);
  const auto darkness = [&](const Vector3d& place) {
    const Vector3d to = place - camera.position;
    const double scale = 2 * Camera::kHalfWidth * to.dot(camera.forward);
    const int x = static_cast<int>(kSize * (0.5 + to.dot(camera.right) / scale));
    const int y = static_cast<int>(kSize * (0.5 - to.dot(camera.up) / scale));
    return image.pixel(x, y)[3];
  };
  // The lamp's direction is as in render.cpp: of 1.6 m above, 0.75 m to the left.
  const Vector3d behind = camera.up - camera.up.z() * Vector3d::UnitZ();
  const Vector3d shadow = 0.12 / 1.6 * (0.75 * camera.right + 0.62 * behind.normalized());
  EXPECT_GT(darkness(shadow), darkness(-shadow) + 40);
}

}  // namespace
}  // namespace runtime
