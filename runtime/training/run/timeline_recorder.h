// Keeps the timeline of the current episode beside its poses.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/training/run/episode.h"

namespace runtime {

class TimelineRecorder {
 public:
  // For at most `most_frames` frames.
  TimelineRecorder(int pose_count, size_t most_frames);

  // The next episode is of this task, as long as nobody puts another in its place: then it has no
  // timeline. Takes memory where the task needs more than those before it.
  void StartEpisode(const UniversalTask& task);
  // What is now, right after the start of the episode or a time step, is sample number `frame`.
  void Note(size_t frame, const EpisodeModules& modules);
  // The same for the sample at the end of the episode.
  void NoteEnd(const EpisodeModules& modules);
  // Sample number `from` is number `to` from now on.
  void Move(size_t from, size_t to);

  // Of the episode that has ended, with its first `frames` samples and the last one, packed; ""
  // where it has none.
  std::string Finish(size_t frames) const;

 private:
  bool IsOf(const UniversalTask& task) const;

  double* Row(size_t sample) { return values_.data() + sample * width_; }
  const double* Row(size_t sample) const { return values_.data() + sample * width_; }
  uint8_t* Contacts(size_t sample) { return contacts_.data() + sample * contact_bytes_; }

  size_t most_frames_;  // and the number of the row for the end of the episode
  size_t contact_bytes_;
  int64_t task_ = 0;       // its id
  bool is_whole_ = false;  // of one task, from its start to its end
  size_t terms_ = 0, metrics_ = 0, phases_ = 0;
  size_t width_ = 0;  // of a row: return, terms and metrics, and the phase where there are any
  double end_ = 0;
  std::vector<double> values_;  // [sample][...]; return and terms from the start of the episode on
  std::vector<uint8_t> contacts_;
};

}  // namespace runtime
