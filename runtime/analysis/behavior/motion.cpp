#include "runtime/analysis/behavior/motion.h"

#include "runtime/training/run/recorded_poses.h"
#include "runtime/training/run/recorder.h"

namespace runtime {

Motion ReadMotion(const Recording& recording, int link_count) {
  const std::vector<float> poses = ReadPoses(recording, static_cast<size_t>(link_count));
  Motion motion{recording.frame_interval, link_count, {}, {}};
  for (size_t i = 0; i < poses.size(); i += Recorder::kFloatsPerLink) {
    const float* pose = poses.data() + i;
    motion.positions.emplace_back(pose[0], pose[1], pose[2]);
    motion.orientations.push_back(
        Eigen::Quaterniond(pose[3], pose[4], pose[5], pose[6]).normalized());
  }
  return motion;
}

Motion OfLinks(const Motion& motion, size_t count) {
  Motion links{motion.frame_interval, static_cast<int>(count), {}, {}};
  for (int frame = 0; frame < motion.frame_count(); ++frame) {
    for (int link = 0; link < links.link_count; ++link) {
      links.positions.push_back(motion.position(frame, link));
      links.orientations.push_back(motion.orientation(frame, link));
    }
  }
  return links;
}

}  // namespace runtime
