#include "runtime/analysis/picture/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace runtime {
namespace {

using Eigen::Vector3d;

// Where the camera is, seen from what it looks at: ahead along the way, beside it, above; as on the
// page of a run (web/src/replay/stage.ts).
constexpr double kAhead = 0.4, kBeside = 1.12, kAbove = 0.4;
constexpr double kMargin = 0.05;  // of the picture, that stays free on each side

// The direction of the way, if the robot went farther than it is long itself; otherwise +x.
Vector3d WayOf(const Motion& motion, double size, int from, int to) {
  Vector3d way = motion.position(to, 0) - motion.position(from, 0);
  way.z() = 0;
  if (!(way.norm() > size)) return Vector3d::UnitX();
  if (way.x() < 0) way = -way;
  return way / way.norm();
}

// What the links of a frame reach along a direction, from least to greatest.
struct Reach {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  double middle() const { return 0.5 * (low + high); }
  double size() const { return high - low; }
};

Reach ReachAlong(const Vector3d& direction, const Motion& motion,
                 const std::vector<robot::Link>& links, int frame) {
  Reach reach;
  for (size_t i = 0; i < links.size(); ++i) {
    const double place = motion.position(frame, static_cast<int>(i)).dot(direction);
    const double radius = BoundingRadiusOfLink(links[i].shape);
    reach.low = std::min(reach.low, place - radius);
    reach.high = std::max(reach.high, place + radius);
  }
  return reach;
}

// How far the camera must be from `target` to have a ball at `center` in the picture.
double DistanceFor(const Camera& camera, const Vector3d& target, const Vector3d& center,
                   double radius) {
  constexpr double kTangent = (1 - 2 * kMargin) * Camera::kHalfWidth;
  const double cosine = 1 / std::sqrt(1 + kTangent * kTangent);
  const Vector3d to = center - target;
  const double aside = std::max(std::abs(to.dot(camera.right)), std::abs(to.dot(camera.up)));
  return (aside + radius / cosine) / kTangent - to.dot(camera.forward);
}

}  // namespace

Ray Camera::RayThrough(double x, double y) const {
  const Vector3d direction =
      forward + (2 * x - 1) * kHalfWidth * right + (2 * y - 1) * kHalfWidth * up;
  return {position, direction / direction.norm()};
}

std::vector<Camera> PlaceCameras(const Motion& motion, const std::vector<robot::Link>& links,
                                 const std::vector<int>& frames) {
  const double size = ReachAlong(Vector3d::UnitX(), motion, links, frames.front()).size();
  const Vector3d way = WayOf(motion, size, frames.front(), frames.back());
  const Vector3d beside = way.cross(Vector3d::UnitZ());
  Camera camera;
  camera.forward = -(kAhead * way + kBeside * beside + kAbove * Vector3d::UnitZ()).normalized();
  camera.right = camera.forward.cross(Vector3d::UnitZ()).normalized();
  camera.up = camera.right.cross(camera.forward);

  double top = 0;
  for (const int frame : frames) {
    top = std::max(top, ReachAlong(Vector3d::UnitZ(), motion, links, frame).high);
  }
  const Vector3d away = Vector3d::UnitZ().cross(camera.right);  // level, from the camera
  std::vector<Vector3d> targets;
  for (const int frame : frames) {
    targets.push_back(ReachAlong(camera.right, motion, links, frame).middle() * camera.right +
                      ReachAlong(away, motion, links, frame).middle() * away +
                      0.5 * top * Vector3d::UnitZ());
    for (size_t i = 0; i < links.size(); ++i) {
      camera.distance =
          std::max(camera.distance,
                   DistanceFor(camera, targets.back(), motion.position(frame, static_cast<int>(i)),
                               BoundingRadiusOfLink(links[i].shape)));
    }
  }
  std::vector<Camera> cameras;
  for (const Vector3d& target : targets) {
    camera.position = target - camera.distance * camera.forward;
    cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace runtime
