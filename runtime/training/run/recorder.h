// Keeps the poses of the current episode, so that it can be stored if it turns out to be worth it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "runtime/training/environment/environment.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

class Recorder {
 public:
  static constexpr double kFrameInterval = 0.02;   // [s]
  static constexpr double kMaximumDuration = 120;  // [s] at this interval
  static constexpr int kFloatsPerLink = 7;         // x y z qw qx qy qz

  // Takes all memory it will ever need. A longer episode is recorded at a coarser interval.
  Recorder(int link_count, double time_step);

  void StartEpisode();

  // Call after the start of the episode and after each time step. Where the next frame is due,
  // the result is the place to write it to: kFloatsPerLink floats for each link; otherwise it is
  // empty.
  std::span<float> NextFrame();

  // The same with what the environment is like now for the frame.
  void Capture(const Environment& environment);

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
};

}  // namespace runtime
