#include "runtime/analysis/robot/pose_pictures.h"

#include <algorithm>
#include <iterator>

#include "runtime/analysis/picture/snapshot_strip.h"
#include "runtime/analysis/robot/joint_marks.h"
#include "runtime/analysis/robot/site_marks.h"

namespace runtime {

std::string PosePictures(const robot::RobotDescription& robot, const std::vector<HeldPose>& poses,
                         int height) {
  Motion motion;
  motion.frame_interval = 1;
  motion.link_count = static_cast<int>(robot.links.size());
  const auto add = [&](const std::vector<LinkFrame>& frames) {
    for (const LinkFrame& frame : frames) {
      motion.positions.push_back(frame.position);
      motion.orientations.push_back(frame.orientation);
    }
  };
  StripOptions options;
  for (const HeldPose& held : poses) {
    add(held.start);
    options.strokes.push_back(JointMarks(robot, held.start, held.size));
    std::ranges::move(SiteMarks(robot, held.start, held.size),
                      std::back_inserter(options.strokes.back()));
    add(held.end);
    options.strokes.emplace_back();
  }
  options.count = motion.frame_count();
  options.height = height;
  return SnapshotStrip(motion, robot.links, options);
}

}  // namespace runtime
