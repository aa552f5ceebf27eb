#include "runtime/analysis/picture/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plugins/robot/shape_extent.h"

namespace runtime {
namespace {

using Eigen::Vector3d;

constexpr double kRounding = 0.14;  // radius of a box's edges, of its least extent

void KeepNearer(std::optional<Hit>& nearest, const std::optional<Hit>& hit) {
  if (hit && (!nearest || hit->distance < nearest->distance)) nearest = hit;
}

// The smaller solution of a t^2 + 2 b t + c = 0 if it is real and not negative; `a` is positive.
std::optional<double> FirstRoot(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return std::nullopt;
  const double root = (-b - std::sqrt(discriminant)) / a;
  if (root < 0) return std::nullopt;
  return root;
}

std::optional<Hit> HitSphere(const Vector3d& center, double radius, const Ray& ray) {
  const Vector3d from = ray.origin - center;
  const auto distance = FirstRoot(1, from.dot(ray.direction), from.squaredNorm() - radius * radius);
  if (!distance) return std::nullopt;
  return Hit{*distance, (from + *distance * ray.direction) / radius};
}

// All points within `radius` of a line of twice `half_length` along `axis`. A ray that enters the
// endless tube around it beside the line enters the capsule there; beyond the line's end it can
// meet only the ball at that end.
std::optional<Hit> HitCapsule(const Vector3d& center, int axis, double half_length, double radius,
                              const Ray& ray) {
  Vector3d from = ray.origin - center;
  Vector3d across = ray.direction;
  const double along = from[axis];
  from[axis] = across[axis] = 0;
  const double outside = from.squaredNorm() - radius * radius;
  std::optional<double> entry;
  if (outside >= 0) {
    const double speed = across.squaredNorm();
    if (speed > 0) entry = FirstRoot(speed, from.dot(across), outside);
    if (!entry) return std::nullopt;
  }
  const double place = along + entry.value_or(0) * ray.direction[axis];
  if (std::abs(place) > half_length) {
    const double end = place > 0 ? half_length : -half_length;
    return HitSphere(center + end * Vector3d::Unit(axis), radius, ray);
  }
  if (!entry) return std::nullopt;  // it begins inside
  return Hit{*entry, (from + *entry * across) / radius};
}

struct Entry {
  double distance = 0;
  int axis = 0;  // of the face
};

// Where the ray enters a box with sharp edges.
std::optional<Entry> EnterBox(const Vector3d& half, const Ray& ray) {
  Entry entry{-1, 0};
  double exit = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double from = ray.origin[axis];
    const double speed = ray.direction[axis];
    if (speed == 0) {
      if (std::abs(from) > half[axis]) return std::nullopt;
      continue;
    }
    const double sign = speed > 0 ? 1 : -1;
    const double enters = (-sign * half[axis] - from) / speed;
    exit = std::min(exit, (sign * half[axis] - from) / speed);
    if (enters > entry.distance) entry = {enters, axis};
  }
  if (entry.distance < 0 || entry.distance > exit) return std::nullopt;
  return entry;
}

// The box's edges and corners: its twelve edges as capsules.
std::optional<Hit> HitEdges(const Vector3d& inner, double radius, const Ray& ray) {
  std::optional<Hit> nearest;
  for (int axis = 0; axis < 3; ++axis) {
    for (int edge = 0; edge < 4; ++edge) {
      Vector3d center = Vector3d::Zero();
      center[(axis + 1) % 3] = (edge & 1 ? 1 : -1) * inner[(axis + 1) % 3];
      center[(axis + 2) % 3] = (edge & 2 ? 1 : -1) * inner[(axis + 2) % 3];
      KeepNearer(nearest, HitCapsule(center, axis, inner[axis], radius, ray));
    }
  }
  return nearest;
}

// A rounded box is flat where the sharp one is entered away from its edges; elsewhere only an edge
// can be met, since all that is flat lies on the sharp box.
std::optional<Hit> HitBox(const robot::LinkShape& box, const Ray& ray) {
  const Vector3d half = 0.5 * Vector3d(box.size.data());
  const std::optional<Entry> entry = EnterBox(half, ray);
  if (!entry) return std::nullopt;
  const double radius = EdgeRadius(box);
  const Vector3d inner = half - Vector3d::Constant(radius);
  Vector3d place = ray.At(entry->distance);
  place[entry->axis] = 0;
  if ((place.cwiseAbs() - inner).maxCoeff() > 0) return HitEdges(inner, radius, ray);
  const double outwards = ray.direction[entry->axis] > 0 ? -1 : 1;
  return Hit{entry->distance, outwards * Vector3d::Unit(entry->axis)};
}

// It is entered where the ray is first both between its two ends and within the endless tube around
// its axis.
std::optional<Hit> HitCylinder(const robot::LinkShape& shape, const Ray& ray) {
  const int axis = shape.axis;
  const double half = shape.length / 2;
  Vector3d from = ray.origin;
  Vector3d across = ray.direction;
  const double along = from[axis];
  const double speed = across[axis];
  from[axis] = across[axis] = 0;
  double enters_ends = -1;
  double leaves_ends = std::numeric_limits<double>::infinity();
  if (speed != 0) {
    const double sign = speed > 0 ? 1 : -1;
    enters_ends = (-sign * half - along) / speed;
    leaves_ends = (sign * half - along) / speed;
  } else if (std::abs(along) > half) {
    return std::nullopt;
  }
  double enters_tube = -1;
  double leaves_tube = std::numeric_limits<double>::infinity();
  const double square = across.squaredNorm();
  const double outside = from.squaredNorm() - shape.radius * shape.radius;
  if (square > 0) {
    const double middle = from.dot(across);
    const double discriminant = middle * middle - square * outside;
    if (discriminant < 0) return std::nullopt;
    enters_tube = (-middle - std::sqrt(discriminant)) / square;
    leaves_tube = (-middle + std::sqrt(discriminant)) / square;
  } else if (outside > 0) {
    return std::nullopt;
  }
  const double entry = std::max(enters_ends, enters_tube);
  if (entry < 0 || entry > std::min(leaves_ends, leaves_tube)) return std::nullopt;
  if (enters_tube > enters_ends) return Hit{entry, (from + entry * across) / shape.radius};
  return Hit{entry, (speed > 0 ? -1 : 1) * Vector3d::Unit(axis)};
}

// A ray is within a convex body from where it has passed the last plane inwards until it passes the
// first one outwards.
std::optional<Hit> HitConvex(const ConvexHull& hull, const Ray& ray) {
  double entry = -1;
  double exit = std::numeric_limits<double>::infinity();
  const HullFace* entered = nullptr;
  for (const HullFace& face : hull.faces) {
    const double speed = face.normal.dot(ray.direction);
    const double inside = face.distance - face.normal.dot(ray.origin);
    if (speed == 0) {
      if (inside < 0) return std::nullopt;
      continue;
    }
    const double passes = inside / speed;
    if (speed > 0) {
      exit = std::min(exit, passes);
    } else if (passes > entry) {
      entry = passes;
      entered = &face;
    }
  }
  if (entry < 0 || entry > exit) return std::nullopt;
  return Hit{entry, entered->normal};
}

}  // namespace

Solid::Solid(const robot::LinkShape& shape) : shape_(&shape) {
  if (shape.kind == robot::ShapeKind::kConvex) hull_ = HullOf(shape.points);
}

std::optional<Hit> Solid::FirstHit(const Ray& ray) const {
  const robot::LinkShape& shape = *shape_;
  switch (shape.kind) {
    case robot::ShapeKind::kBox:
      return HitBox(shape, ray);
    case robot::ShapeKind::kCapsule: {
      const double half_length = std::max(0., shape.length / 2 - shape.radius);
      return HitCapsule(Vector3d::Zero(), shape.axis, half_length, shape.radius, ray);
    }
    case robot::ShapeKind::kCylinder:
      return HitCylinder(shape, ray);
    case robot::ShapeKind::kSphere:
      return HitSphere(Vector3d::Zero(), shape.radius, ray);
    case robot::ShapeKind::kConvex:
      break;
  }
  return HitConvex(hull_, ray);
}

double EdgeRadius(const robot::LinkShape& box) {
  return kRounding * *std::ranges::min_element(box.size);
}

double BoundingRadiusOfLink(const robot::LinkShape& shape) {
  return robot::RadiusAround(shape) + Vector3d(shape.position.data()).norm();
}

}  // namespace runtime
