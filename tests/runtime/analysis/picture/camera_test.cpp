#include "runtime/analysis/picture/camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/runtime/analysis/picture/standing_ball.h"

namespace runtime {
namespace {

using Eigen::Vector3d;

std::vector<Camera> CamerasFor(const std::vector<Vector3d>& places, double radius = 0.1) {
  std::vector<int> frames;
  for (size_t i = 0; i < places.size(); ++i) frames.push_back(static_cast<int>(i));
  return PlaceCameras(MotionThrough(places), Ball(radius), frames);
}

// Where the picture shows a place: (0, 0) is the lower left corner, (1, 1) the upper right one.
Eigen::Vector2d InPicture(const Camera& camera, const Vector3d& place) {
  const Vector3d to = place - camera.position;
  const double scale = 2 * Camera::kHalfWidth * to.dot(camera.forward);
  return {0.5 + to.dot(camera.right) / scale, 0.5 + to.dot(camera.up) / scale};
}

TEST(Camera, SeesTwelveDegreesToEachSide) {
  EXPECT_DOUBLE_EQ(Camera::kHalfWidth, std::tan(12 * M_PI / 180));
  const Camera camera = CamerasFor({{0, 0, 0.1}}).front();
  const Ray ray = camera.RayThrough(0.3, 0.9);
  EXPECT_NEAR(ray.direction.norm(), 1, 1e-15);
  EXPECT_NEAR((InPicture(camera, ray.At(2)) - Eigen::Vector2d(0.3, 0.9)).norm(), 0, 1e-12);
  EXPECT_NEAR(camera.RayThrough(0, 0.5).direction.dot(camera.forward), std::cos(12 * M_PI / 180),
              1e-12);
}

// The page's view: from the right of a robot that faces +x, a little ahead and above.
TEST(PlaceCameras, LooksFromTheSideOfTheWay) {
  for (const double x : {3., -3.}) {  // forward and backward look alike
    const Camera camera = CamerasFor({{0, 0, 0.1}, {x, 0, 0.1}}).front();
    const Vector3d from = (camera.position - camera.target()).normalized();
    EXPECT_NEAR((from - Vector3d(0.4, -1.12, 0.4).normalized()).norm(), 0, 1e-12);
    EXPECT_GT(camera.right.x(), 0.9);
  }
  const Camera camera = CamerasFor({{0, 0, 0.1}, {0.001, 3, 0.1}}).front();
  EXPECT_GT(camera.right.y(), 0.9);
}

TEST(PlaceCameras, TakesASmallWayForNone) {
  EXPECT_GT(CamerasFor({{0, 0, 0.1}, {0, 0.15, 0.1}}).front().right.x(), 0.9);
}

TEST(PlaceCameras, KeepsTheRobotInThePicture) {
  const std::vector<Vector3d> places = {{0, 0, 0.1}, {1, 0.2, 0.8}, {4, -0.3, 0.2}};
  const std::vector<Camera> cameras = CamerasFor(places);
  double farthest = 0;
  for (size_t i = 0; i < places.size(); ++i) {
    EXPECT_EQ(cameras[i].distance, cameras.front().distance);
    EXPECT_EQ(cameras[i].target().z(), cameras.front().target().z());
    EXPECT_NEAR(InPicture(cameras[i], places[i]).x(), 0.5, 1e-12);
    for (const Vector3d& side : {cameras[i].up, cameras[i].right}) {
      for (const double sign : {-1., 1.}) {
        const Eigen::Vector2d edge = InPicture(cameras[i], places[i] + sign * 0.1 * side);
        farthest = std::max(farthest, (edge - Eigen::Vector2d(0.5, 0.5)).cwiseAbs().maxCoeff());
      }
    }
  }
  EXPECT_NEAR(farthest, 0.45, 0.005);  // that is how close the edge may be
}

}  // namespace
}  // namespace runtime
