// Shows whoever started a run how it goes: a picture that stays up to date on a terminal
// (progress_screen.h), a line every so often elsewhere, or one JSON object per episode for
// programs.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runtime/training/run/live_text.h"
#include "runtime/training/run/progress_screen.h"
#include "runtime/training/run/return_statistics.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

enum class ProgressStyle {
  kText,   // for people: lines that are kept up to date on a terminal
  kPlain,  // the same in lines that stay, on a terminal, too
  kJson,
  kQuiet
};

inline bool IsForPeople(ProgressStyle style) {
  return style == ProgressStyle::kText || style == ProgressStyle::kPlain;
}

// {"episode": 1, "task": "crawling", "return": ..., "end": {...}, "terms": {...}, ...}; with
// shadows also "shadows": {"MODULE": {"task": ..., "return": ..., ...}}. "learner" is what the
// learner shows: {"learning_rate": 0.3, ...}. The tasks are those of `run`.
nlohmann::ordered_json EpisodeJson(const EpisodeRecord& episode, const RunRecord& run);

class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  // Everything goes to `output`, warnings to `warnings`; neither is owned.
  Progress(ProgressStyle style, const RunRecord& run, std::FILE* output, std::FILE* warnings);

  // An episode that was over before this process began.
  void Recall(const EpisodeRecord& episode);
  // Whether what is shown is kept up to date.
  bool is_live() const { return live_.is_on_terminal(); }

  // Call after `episode` was counted by `statistics`, which cover all episodes of the run up to
  // now.
  void FinishEpisode(const EpisodeRecord& episode, const ReturnStatistics& statistics);
  // A line for the user, between the others.
  void Warn(const std::string& text);
  void Note(const std::string& text);  // not for programs: nothing with kJson and kQuiet
  // What the terminal shows is the last of it, and stays there.
  void Leave();

 private:
  void Count(const EpisodeRecord& episode);
  void Show();
  void Print(std::FILE* output, const std::string& text);

  ProgressStyle style_;
  const RunRecord& run_;
  std::FILE* output_;
  std::FILE* warnings_;
  LiveText live_;
  ProgressPicture picture_;
  int64_t task_ = 0;                            // that pays
  std::deque<std::vector<double>> last_terms_;  // of its last episodes
  bool is_shown_ = false;                       // on a terminal
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_shown_ = start_;
  double simulated_seconds_ = 0;  // since the start of this process
  int64_t episodes_here_ = 0;
};

}  // namespace runtime
