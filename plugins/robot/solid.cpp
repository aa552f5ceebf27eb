#include <algorithm>
#include <cmath>

#include "plugins/robot/robot_description.h"

namespace robot {
namespace {

Vector3 Difference(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector3 Cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double Dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double Length(const Vector3& a) { return std::sqrt(Dot(a, a)); }

}  // namespace

// The point that is farthest from the first one gives a line, the one farthest from that a plane,
// and the one farthest from that a height.
bool IsSolid(const std::vector<Vector3>& points) {
  constexpr double kThin = 1e-3;
  if (points.size() < 4) return false;
  const auto farthest = [&](const auto& distance) {
    return *std::ranges::max_element(points, {}, distance);
  };
  const Vector3& origin = points.front();
  const auto from = [&](const Vector3& p) { return Difference(p, origin); };
  const Vector3 along = from(farthest([&](const Vector3& p) { return Length(from(p)); }));
  const double length = Length(along);
  const auto area = [&](const Vector3& p) { return Cross(along, from(p)); };
  const Vector3 normal = area(farthest([&](const Vector3& p) { return Length(area(p)); }));
  const double width = Length(normal) / length;
  const auto height = [&](const Vector3& p) { return std::abs(Dot(normal, from(p))); };
  const double thickness = height(farthest(height)) / Length(normal);
  return std::isfinite(length) && width > kThin * length && thickness > kThin * length;
}

}  // namespace robot
