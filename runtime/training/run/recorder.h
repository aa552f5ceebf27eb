// Keeps the poses of the current episode, and what was paid and measured meanwhile, so that it can
// be stored if it turns out to be worth it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/training/run/episode.h"
#include "runtime/training/run/run_records.h"
#include "runtime/training/run/timeline_recorder.h"

namespace runtime {

class Recorder {
 public:
  static constexpr double kFrameInterval = 0.02;   // [s]
  static constexpr double kMaximumDuration = 120;  // [s] at this interval
  static constexpr int kFloatsPerLink = 7;         // x y z qw qx qy qz

  // Takes all memory it will ever need. A longer episode is recorded at a coarser interval.
  Recorder(int pose_count, double time_step);

  void StartEpisode();

  // Call after the start of the episode and after each time step. Where the next frame is due,
  // the result is the place to write it to: kFloatsPerLink floats for each pose; otherwise it is
  // empty.
  std::span<float> NextFrame();

  // StartEpisode() with `steps` 0; then NextFrame(), and where it is due what these modules are
  // like now, after so many time steps, for the frame; also where the episode is over.
  void Capture(int64_t steps, const EpisodeModules& modules);

  // The episode up to now, compressed.
  Recording Finish(bool is_best) const;

 private:
  void HalveFrameRate();

  size_t frame_size_;  // floats
  size_t capacity_;    // frames
  double time_step_;
  long steps_per_frame_at_start_;
  long steps_per_frame_ = 1;
  long step_ = 0;  // since the start of the episode
  size_t frames_ = 0;
  std::vector<float> poses_;
  TimelineRecorder timeline_;
};

}  // namespace runtime
