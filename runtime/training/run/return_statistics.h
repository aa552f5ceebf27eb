// What the returns of a run's episodes amount to.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

class ReturnStatistics {
 public:
  static constexpr size_t kMeanOver = 20;

  // Whether `episode` beats all before it. A diverged one, or one without a finite return, never
  // does: its return means nothing.
  bool IsBest(const EpisodeRecord& episode) const;
  void Add(const EpisodeRecord& episode);

  double last() const { return last_returns_.empty() ? 0 : last_returns_.back(); }
  double mean() const;                   // of the last kMeanOver, or of as many as there are
  double best() const { return best_; }  // -infinity if there is none
  int64_t best_episode() const { return best_episode_; }  // 0 if there is none

 private:
  std::vector<double> last_returns_;  // at most kMeanOver, the oldest first
  double best_ = -std::numeric_limits<double>::infinity();
  int64_t best_episode_ = 0;
};

}  // namespace runtime
