#include "runtime/analysis/behavior/floor_distance.h"

#include "plugins/robot/shape_extent.h"

namespace runtime {

double LowestPoint(const robot::LinkShape& shape, double link_height,
                   const Eigen::Quaterniond& orientation) {
  const Eigen::Vector3d in_link = orientation.conjugate() * Eigen::Vector3d::UnitZ();  // upward
  const auto& [w, x, y, z] = shape.orientation;
  const Eigen::Vector3d up = Eigen::Quaterniond(w, x, y, z).conjugate() * in_link;
  const double height = link_height + in_link.dot(Eigen::Vector3d(shape.position.data()));
  return height - robot::ReachAlong(shape, {-up[0], -up[1], -up[2]});
}

}  // namespace runtime
