// The ground of a picture: where rays from above meet it, and which way it faces there.
#pragma once

#include <optional>
#include <vector>

#include "plugins/world/ground.h"
#include "runtime/analysis/picture/shapes.h"

namespace runtime {

class Terrain {
 public:
  explicit Terrain(const world::Ground& ground);

  std::optional<Hit> FirstHit(const Ray& ray) const;
  // Whether what the ray meets at this distance lies behind the ground.
  bool Hides(const Ray& ray, double distance) const;

 private:
  std::optional<double> DistanceToPlane(const Ray& ray) const;
  void MeetBlock(const world::Block& block, const Ray& ray, std::optional<Hit>& first) const;
  void MeetHills(const world::HeightMap& map, const Ray& ray, std::optional<Hit>& first) const;

  const world::Ground ground_;
  Eigen::Vector3d normal_;  // of the plane through the origin
  std::vector<world::Block> blocks_;
  double highest_ = 0;  // of the hills [m]
};

}  // namespace runtime
