#include "runtime/training/run/recorded_poses.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "runtime/base/user_error.h"
#include "runtime/training/run/compression.h"
#include "runtime/training/run/recorder.h"

namespace runtime {

std::vector<float> ReadPoses(const Recording& recording, size_t link_count) {
  const std::string bytes = Decompress(recording.poses, "its data");
  const size_t frame_size = link_count * Recorder::kFloatsPerLink;
  const size_t frames = static_cast<size_t>(std::max<int64_t>(recording.frames, 0));
  if (frames == 0 || !(recording.frame_interval > 0) ||
      bytes.size() != frames * frame_size * sizeof(float)) {
    throw UserError("its data does not fit the robot's links");
  }
  std::vector<float> poses(bytes.size() / sizeof(float));
  std::memcpy(poses.data(), bytes.data(), bytes.size());
  const auto bad = std::ranges::find_if(poses, [](float value) { return !std::isfinite(value); });
  const auto finite = static_cast<size_t>(bad - poses.begin()) / frame_size;
  if (finite == 0) throw UserError("its poses are not finite");
  poses.resize(finite * frame_size);
  return poses;
}

}  // namespace runtime
