// A recorded episode as the positions and orientations of links.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

struct Motion {
  double frame_interval = 0;  // [s]
  int link_count = 0;
  // [frame][link], at least one frame; of each link's center in the world frame [m].
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Quaterniond> orientations;

  int frame_count() const { return static_cast<int>(positions.size()) / link_count; }
  double duration() const { return frame_interval * (frame_count() - 1); }  // [s]
  const Eigen::Vector3d& position(int frame, int link) const {
    return positions[static_cast<size_t>(frame * link_count + link)];
  }
  const Eigen::Quaterniond& orientation(int frame, int link) const {
    return orientations[static_cast<size_t>(frame * link_count + link)];
  }
};

// The motion of a robot with `link_count` links. Throws UserError where the recording is damaged.
// Things of its world count as links.
Motion ReadMotion(const Recording& recording, int link_count);

// The motion of the first links alone.
Motion OfLinks(const Motion& motion, size_t count);

}  // namespace runtime
