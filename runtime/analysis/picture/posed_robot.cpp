#include "runtime/analysis/picture/posed_robot.h"

#include <algorithm>

#include "plugins/robot/shape_extent.h"

namespace runtime {
namespace {

using Eigen::Vector3d;

// Along the axes of the shape; a convex one is taken as the box around it.
Vector3d HalfExtents(const robot::LinkShape& shape) {
  if (shape.kind == robot::ShapeKind::kBox) return 0.5 * Vector3d(shape.size.data());
  Vector3d low = Vector3d::Zero();
  Vector3d high = Vector3d::Zero();
  for (const robot::Vector3& point : shape.points) {
    low = low.cwiseMin(Vector3d(point.data()));
    high = high.cwiseMax(Vector3d(point.data()));
  }
  return 0.5 * (high - low);
}

bool HasExtents(const robot::LinkShape& shape) {
  return shape.kind == robot::ShapeKind::kBox || shape.kind == robot::ShapeKind::kConvex;
}

double RadiusOf(const robot::LinkShape& shape) {
  return HasExtents(shape) ? HalfExtents(shape).minCoeff() : shape.radius;
}

Vector3d CoreOf(const robot::LinkShape& shape) {
  switch (shape.kind) {
    case robot::ShapeKind::kBox:
    case robot::ShapeKind::kConvex:
      return HalfExtents(shape) - Vector3d::Constant(RadiusOf(shape));
    case robot::ShapeKind::kCapsule:
    case robot::ShapeKind::kCylinder:
      return std::max(0., shape.length / 2 - shape.radius) * Vector3d::Unit(shape.axis);
    case robot::ShapeKind::kSphere:
      break;
  }
  return Vector3d::Zero();
}

}  // namespace

PosedRobot::PosedRobot(const std::vector<robot::Link>& links, const Motion& motion, int frame) {
  for (size_t i = 0; i < links.size(); ++i) {
    const robot::LinkShape& shape = links[i].shape;
    const int link = static_cast<int>(i);
    const auto& [w, x, y, z] = shape.orientation;
    const Eigen::Quaterniond& turn = motion.orientation(frame, link);
    const Bounds bounds{motion.position(frame, link) + turn * Vector3d(shape.position.data()),
                        robot::RadiusAround(shape)};
    const Eigen::Quaterniond shape_turn = turn * Eigen::Quaterniond(w, x, y, z);
    links_.push_back({Solid(shape), bounds,
                      (shape.IsMoved() ? shape_turn : turn).toRotationMatrix(), CoreOf(shape),
                      RadiusOf(shape)});
    whole_.center += bounds.center / static_cast<double>(links.size());
  }
  for (const Posed& link : links_) {
    const double reach = (link.bounds.center - whole_.center).norm() + link.bounds.radius;
    whole_.radius = std::max(whole_.radius, reach);
  }
}

Ray PosedRobot::ToLink(const Posed& link, const Ray& ray) {
  return {link.rotation.transpose() * (ray.origin - link.bounds.center),
          link.rotation.transpose() * ray.direction};
}

bool PosedRobot::Bounds::IsNear(const Ray& ray, double width, double widening) const {
  const Vector3d to = center - ray.origin;
  const double along = std::max(0., to.dot(ray.direction));
  const double reach = radius + width + widening * (along + radius);
  return (to - along * ray.direction).squaredNorm() < reach * reach;
}

void PosedRobot::FindNear(const Ray& ray, double width, double widening,
                          std::vector<size_t>& near) const {
  near.clear();
  if (!whole_.IsNear(ray, width, widening)) return;
  for (size_t i = 0; i < links_.size(); ++i) {
    if (links_[i].bounds.IsNear(ray, width, widening)) near.push_back(i);
  }
}

std::optional<RobotHit> PosedRobot::FirstHitOf(const std::vector<size_t>& links,
                                               const Ray& ray) const {
  std::optional<RobotHit> first;
  for (const size_t i : links) {
    const Ray local = ToLink(links_[i], ray);
    const std::optional<Hit> hit = links_[i].solid.FirstHit(local);
    if (!hit || (first && first->hit.distance <= hit->distance)) continue;
    first = RobotHit{i, {hit->distance, links_[i].rotation * hit->normal}, local.At(hit->distance)};
  }
  return first;
}

bool PosedRobot::IsBlocked(const std::vector<size_t>& links, const Ray& ray, size_t except) const {
  return std::ranges::any_of(links, [&](size_t i) {
    const Posed& link = links_[i];
    return i != except && link.bounds.IsNear(ray, 0, 0) &&
           link.solid.FirstHit(ToLink(link, ray)).has_value();
  });
}

// As if the link were but the ball around the point of its core that is nearest. The farther away
// it is the less it counts, down to nothing, so that most links need not be looked at.
double PosedRobot::Hidden(const Posed& link, const Vector3d& place, const Vector3d& normal) {
  constexpr double kReach = 5;  // of so many radii
  const double reach = kReach * link.radius;
  const Vector3d from = place - link.bounds.center;
  const double farthest = link.bounds.radius + reach;
  if (from.squaredNorm() > farthest * farthest) return 0;
  const Vector3d local = link.rotation.transpose() * from;
  const Vector3d to = link.rotation * (local.cwiseMin(link.core).cwiseMax(-link.core) - local);
  const double facing = normal.dot(to);
  const double squared = std::max(to.squaredNorm(), link.radius * link.radius);
  if (!(facing > 0) || squared >= reach * reach) return 0;
  const double fading = 1 - squared / (reach * reach);
  return std::min(1., facing / std::sqrt(squared)) * link.radius * link.radius / squared * fading;
}

double PosedRobot::Openness(const Vector3d& place, const Vector3d& normal, size_t except) const {
  double open = 1;
  for (size_t i = 0; i < links_.size(); ++i) {
    if (i != except) open *= 1 - Hidden(links_[i], place, normal);
  }
  return open;
}

}  // namespace runtime
