// Whether a robot starts with its links inside each other.
#pragma once

#include <optional>

#include "plugins/robot/start_state.h"
#include "runtime/training/simulation/profile.h"
#include "runtime/training/simulation/world.h"

namespace runtime {

struct LinkOverlap {
  int first;
  int second;
  double depth;  // [m]
};

// The deepest of the overlaps that the start has and its pose has not, or not as deep. `world`: the
// robot in this state.
std::optional<LinkOverlap> FindOverlap(const robot::RobotDescription& robot, const Profile& profile,
                                       const robot::StartState& start, const World& world);

}  // namespace runtime
