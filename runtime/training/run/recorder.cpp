#include "runtime/training/run/recorder.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "runtime/training/run/compression.h"

namespace runtime {

static_assert(std::endian::native == std::endian::little, "recordings are little-endian");

Recorder::Recorder(int pose_count, double time_step)
    : frame_size_(static_cast<size_t>(pose_count) * kFloatsPerLink),
      capacity_(static_cast<size_t>(kMaximumDuration / kFrameInterval) + 1),
      time_step_(time_step),
      steps_per_frame_at_start_(std::max(1L, std::lround(kFrameInterval / time_step))),
      poses_(capacity_ * frame_size_),
      timeline_(pose_count, capacity_) {
  StartEpisode();
}

void Recorder::StartEpisode() {
  steps_per_frame_ = steps_per_frame_at_start_;
  step_ = 0;
  frames_ = 0;
}

std::span<float> Recorder::NextFrame() {
  const long step = step_++;
  if (step % steps_per_frame_ != 0) return {};
  if (frames_ == capacity_) {
    HalveFrameRate();
    if (step % steps_per_frame_ != 0) return {};
  }
  return std::span(poses_).subspan(frame_size_ * frames_++, frame_size_);
}

void Recorder::Capture(int64_t steps, const EpisodeModules& modules) {
  if (steps == 0) {
    StartEpisode();
    timeline_.StartEpisode(*modules.tasks.active);
  }
  if (const std::span<float> frame = NextFrame(); !frame.empty()) {
    modules.environment.CapturePose(frame);
    timeline_.Note(frames_ - 1, modules);
  }
  if (modules.learner.episode_over()) timeline_.NoteEnd(modules);
}

void Recorder::HalveFrameRate() {
  for (size_t kept = 1; 2 * kept < frames_; ++kept) {
    std::copy_n(poses_.begin() + static_cast<std::ptrdiff_t>(2 * kept * frame_size_), frame_size_,
                poses_.begin() + static_cast<std::ptrdiff_t>(kept * frame_size_));
    timeline_.Move(2 * kept, kept);
  }
  frames_ = (frames_ + 1) / 2;
  steps_per_frame_ *= 2;
}

Recording Recorder::Finish(bool is_best) const {
  const auto floats = std::span(poses_).first(frames_ * frame_size_);
  return {static_cast<int64_t>(frames_), static_cast<double>(steps_per_frame_) * time_step_,
          is_best, Compress(std::as_bytes(floats)), timeline_.Finish(frames_)};
}

}  // namespace runtime
