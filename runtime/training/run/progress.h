// Shows whoever started a run how it goes: one line that stays up to date on a terminal, a line
// every so often elsewhere, or one JSON object per episode for programs.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "runtime/training/run/live_text.h"
#include "runtime/training/run/return_statistics.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

enum class ProgressStyle { kText, kJson, kQuiet };

struct ProgressValues {
  int64_t episode = 0;  // finished so far
  int64_t episodes_planned = 0;
  double last_return = 0;
  double mean = 0;
  double best_return = 0;
  double simulated_seconds_per_second = 0;
  double elapsed = 0;    // [s]
  double remaining = 0;  // [s]
};

// "episode 12/1000  return -3.25  mean of 20 -4.1  best 1.5  4.2x real time  0:05 elapsed  6:40
// left". What does not fit into `columns` is left out, the elapsed time first, then the speed, the
// return, the best, the mean, and the time left.
std::string ProgressLine(const ProgressValues& values, size_t columns = kAnyWidth);

// "0:05", "6:40", "1:02:03"
std::string DurationText(double seconds);

// {"episode": 1, "task": "crawling", "return": ..., "end": {...}, "terms": {...}, ...}; with
// shadows also "shadows": {"MODULE": {"task": ..., "return": ..., ...}}. "learner" is what the
// learner shows: {"learning_rate": 0.3, ...}. The tasks are those of `run`.
nlohmann::ordered_json EpisodeJson(const EpisodeRecord& episode, const RunRecord& run);

class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  // Everything goes to `output`, warnings to `warnings`; neither is owned.
  Progress(ProgressStyle style, const RunRecord& run, std::FILE* output, std::FILE* warnings);

  // Call after `episode` was counted by `statistics`, which cover all episodes of the run up to
  // now.
  void FinishEpisode(const EpisodeRecord& episode, const ReturnStatistics& statistics);
  // A line for the user, between the others.
  void Warn(const std::string& text);
  void Note(const std::string& text);  // not for programs: nothing with kJson and kQuiet

 private:
  void Show();

  ProgressStyle style_;
  const RunRecord& run_;
  std::FILE* output_;
  std::FILE* warnings_;
  LiveText live_;
  ProgressValues values_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_line_ = start_;
  double simulated_seconds_ = 0;  // since the start of this process
  int64_t episodes_here_ = 0;
};

}  // namespace runtime
