// Still pictures of a motion, side by side, as a paper prints it.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "plugins/world/world_description.h"
#include "runtime/analysis/behavior/motion.h"
#include "runtime/analysis/picture/strokes.h"

namespace runtime {

struct StripOptions {
  int count = 8;     // of pictures, at least 1
  int height = 260;  // of the strip, and width of each picture [px], at least 1
  // The part of the motion that is shown [s]; what lies outside of the motion is left out.
  double from = 0;
  double to = std::numeric_limits<double>::infinity();
  // So many of the links, at the end, are things of the world: none of the robot's.
  size_t things = 0;
  world::Ground ground{};                      // what all stand on
  std::vector<std::vector<Stroke>> strokes{};  // over each picture; without any none
};

// The times of the pictures [s], equally spaced, the first and the last frame included: those of
// the nearest frames. Where there are fewer frames than pictures some come more than once.
std::vector<double> SnapshotTimes(const Motion& motion, const StripOptions& options = {});

// The pictures at these times as one PNG, `count` times `height` pixels wide. What is not robot is
// transparent but for a faint floor, so that it fits a white page and a dark one. `links`: those of
// the motion, with their shapes.
//
// Equal motions have equal pixels on every machine for which this was built without -ffast-math
// and contracted operations: only additions, multiplications, divisions and square roots of IEEE
// doubles make them, in a fixed order, each pixel on one thread, and neither fonts nor graphics
// hardware. The file is also equal where zlib is.
std::string SnapshotStrip(const Motion& motion, const std::vector<robot::Link>& links,
                          const StripOptions& options = {});

}  // namespace runtime
