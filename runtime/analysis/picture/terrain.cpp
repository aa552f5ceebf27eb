#include "runtime/analysis/picture/terrain.h"

#include <algorithm>

namespace runtime {
namespace {

using Eigen::Vector3d;

void TakeNearer(double distance, const Vector3d& normal, std::optional<Hit>& first) {
  if (!first || distance < first->distance) first = Hit{distance, normal};
}

Vector3d NormalOf(const world::Ground& ground, const world::HeightMap& map, const Vector3d& place) {
  const double x = map.size_x / (map.columns - 1) / 2;
  const double y = map.size_y / (map.rows - 1) / 2;
  const auto height = [&](double dx, double dy) {
    return world::HeightAt(ground, place.x() + dx, place.y() + dy);
  };
  return Vector3d((height(-x, 0) - height(x, 0)) / (2 * x),
                  (height(0, -y) - height(0, y)) / (2 * y), 1)
      .normalized();
}

}  // namespace

Terrain::Terrain(const world::Ground& ground)
    : ground_(ground), normal_(world::NormalOf(ground).data()), blocks_(world::BlocksOf(ground)) {
  if (const auto* map = std::get_if<world::HeightMap>(&ground_.shape))
    highest_ = *std::ranges::max_element(map->heights);
}

std::optional<double> Terrain::DistanceToPlane(const Ray& ray) const {
  const double above = ray.origin.dot(normal_);
  const double sinks = ray.direction.dot(normal_);
  if (!(above > 0 && sinks < 0)) return std::nullopt;
  return -above / sinks;
}

std::optional<Hit> Terrain::FirstHit(const Ray& ray) const {
  std::optional<Hit> first;
  if (const auto distance = DistanceToPlane(ray)) first = Hit{*distance, normal_};
  for (const world::Block& block : blocks_) MeetBlock(block, ray, first);
  if (const auto* map = std::get_if<world::HeightMap>(&ground_.shape)) MeetHills(*map, ray, first);
  return first;
}

bool Terrain::Hides(const Ray& ray, double distance) const {
  const bool is_plane = blocks_.empty() && !std::holds_alternative<world::HeightMap>(ground_.shape);
  if (is_plane) return DistanceToPlane(ray) && ray.At(distance).dot(normal_) < 0;
  const std::optional<Hit> hit = FirstHit(ray);
  return hit && hit->distance < distance;
}

// Its tread and its riser.
void Terrain::MeetBlock(const world::Block& block, const Ray& ray,
                        std::optional<Hit>& first) const {
  const Vector3d& from = ray.origin;
  const Vector3d& along = ray.direction;
  if (from.z() > block.height && along.z() < 0) {
    const double distance = (block.height - from.z()) / along.z();
    const double x = ray.At(distance).x();
    if (block.low_x <= x && x <= block.high_x) TakeNearer(distance, Vector3d::UnitZ(), first);
  }
  if (from.x() < block.low_x && along.x() > 0) {
    const double distance = (block.low_x - from.x()) / along.x();
    const double z = ray.At(distance).z();
    if (0 <= z && z <= block.height) TakeNearer(distance, -Vector3d::UnitX(), first);
  }
}

// In steps of half a cell from where the ray comes as low as the highest hill, the last one halved
// until it ends on the ground.
void Terrain::MeetHills(const world::HeightMap& map, const Ray& ray,
                        std::optional<Hit>& first) const {
  if (!first || !(ray.direction.z() < 0)) return;
  const double start = std::max(0.0, (highest_ - ray.origin.z()) / ray.direction.z());
  const double step = std::min(map.size_x / (map.columns - 1), map.size_y / (map.rows - 1)) / 2;
  const auto is_below = [&](double distance) {
    const Vector3d place = ray.At(distance);
    return place.z() < world::HeightAt(ground_, place.x(), place.y());
  };
  for (double low = start; low < first->distance; low += step) {
    double high = low + step;
    if (!is_below(high)) continue;
    constexpr int kHalvings = 20;
    double above = low;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (above + high) / 2;
      (is_below(middle) ? high : above) = middle;
    }
    return TakeNearer(high, NormalOf(ground_, map, ray.At(high)), first);
  }
}

}  // namespace runtime
