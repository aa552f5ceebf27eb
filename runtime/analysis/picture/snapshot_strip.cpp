#include "runtime/analysis/picture/snapshot_strip.h"

#include <algorithm>
#include <cmath>

#include "runtime/analysis/picture/camera.h"
#include "runtime/analysis/picture/ground.h"
#include "runtime/analysis/picture/image.h"
#include "runtime/analysis/picture/palette.h"
#include "runtime/analysis/picture/png.h"
#include "runtime/analysis/picture/posed_robot.h"
#include "runtime/analysis/picture/render.h"
#include "runtime/analysis/picture/subject.h"
#include "runtime/base/in_parallel.h"

namespace runtime {
namespace {

std::vector<int> SnapshotFrames(const Motion& motion, const StripOptions& options) {
  const double from = std::clamp(options.from, 0., motion.duration());
  const double to = std::clamp(options.to, from, motion.duration());
  std::vector<int> frames;
  for (int i = 0; i < options.count; ++i) {
    const double time = from + (to - from) * i / std::max(1, options.count - 1);
    frames.push_back(std::min(static_cast<int>(std::floor(time / motion.frame_interval + 0.5)),
                              motion.frame_count() - 1));
  }
  return frames;
}

}  // namespace

std::vector<double> SnapshotTimes(const Motion& motion, const StripOptions& options) {
  std::vector<double> times;
  for (const int frame : SnapshotFrames(motion, options)) {
    times.push_back(frame * motion.frame_interval);
  }
  return times;
}

std::string SnapshotStrip(const Motion& motion, const std::vector<robot::Link>& links,
                          const StripOptions& options) {
  const std::vector<int> frames = SnapshotFrames(motion, options);
  const std::vector<robot::Link> robot_links(links.begin(),
                                             links.end() - static_cast<ptrdiff_t>(options.things));
  const std::vector<Camera> cameras = PlaceCameras(motion, robot_links, frames);
  const int followed = SubjectOf(motion, robot_links).front();
  const Terrain terrain(options.ground);
  const std::vector<Paint> paints = PaintsOf(links, options.things);
  Image image(options.count * options.height, options.height);
  const auto draw = [&](size_t i) {
    const PosedRobot robot(links, motion, frames[i]);
    const Ground ground(cameras[i], TrailOf(motion, followed, frames, i));
    const std::span<const Stroke> strokes =
        options.strokes.empty() ? std::span<const Stroke>() : options.strokes[i];
    Render({links, paints, robot, terrain, ground, cameras[i], strokes},
           static_cast<int>(i) * options.height, options.height, image);
  };
  InParallel(frames.size(), draw);  // each has columns of its own
  return EncodePng(ReduceColors(image));
}

}  // namespace runtime
