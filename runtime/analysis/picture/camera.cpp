#include "runtime/analysis/picture/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "runtime/analysis/picture/subject.h"

namespace runtime {
namespace {

using Eigen::Vector3d;

// Where the camera is, seen from what it looks at: ahead along the way, beside it, above; as on the
// page of a run (web/src/replay/stage.ts).
constexpr double kAhead = 0.4, kBeside = 1.12, kAbove = 0.4;
constexpr double kMargin = 0.05;  // of the picture, that stays free on each side

// The direction of the way, if the robot went farther than it is long itself; otherwise +x.
Vector3d WayOf(const Motion& motion, int link, double size, int from, int to) {
  Vector3d way = motion.position(to, link) - motion.position(from, link);
  way.z() = 0;
  if (!(way.norm() > size)) return Vector3d::UnitX();
  if (way.x() < 0) way = -way;
  return way / way.norm();
}

// Links of a motion.
struct Subject {
  const Motion& motion;
  const std::vector<robot::Link>& links;
  std::vector<int> indices;

  double Radius(int link) const {
    return BoundingRadiusOfLink(links[static_cast<size_t>(link)].shape);
  }
};

// What the subject reaches in a frame along a direction, from least to greatest.
struct Reach {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  double middle() const { return 0.5 * (low + high); }
  double size() const { return high - low; }
};

Reach ReachAlong(const Vector3d& direction, const Subject& subject, int frame) {
  Reach reach;
  for (const int link : subject.indices) {
    const double place = subject.motion.position(frame, link).dot(direction);
    reach.low = std::min(reach.low, place - subject.Radius(link));
    reach.high = std::max(reach.high, place + subject.Radius(link));
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
  const Subject subject{motion, links, SubjectOf(motion, links)};
  const double size = ReachAlong(Vector3d::UnitX(), subject, frames.front()).size();
  const Vector3d way = WayOf(motion, subject.indices.front(), size, frames.front(), frames.back());
  const Vector3d beside = way.cross(Vector3d::UnitZ());
  Camera camera;
  camera.forward = -(kAhead * way + kBeside * beside + kAbove * Vector3d::UnitZ()).normalized();
  camera.right = camera.forward.cross(Vector3d::UnitZ()).normalized();
  camera.up = camera.right.cross(camera.forward);

  double top = 0;
  for (const int frame : frames) {
    top = std::max(top, ReachAlong(Vector3d::UnitZ(), subject, frame).high);
  }
  const Vector3d away = Vector3d::UnitZ().cross(camera.right);  // level, from the camera
  std::vector<Vector3d> targets;
  for (const int frame : frames) {
    targets.push_back(ReachAlong(camera.right, subject, frame).middle() * camera.right +
                      ReachAlong(away, subject, frame).middle() * away +
                      0.5 * top * Vector3d::UnitZ());
    for (const int link : subject.indices) {
      camera.distance = std::max(
          camera.distance,
          DistanceFor(camera, targets.back(), motion.position(frame, link), subject.Radius(link)));
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
