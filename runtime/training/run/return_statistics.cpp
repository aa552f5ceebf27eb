#include "runtime/training/run/return_statistics.h"

#include <cmath>
#include <numeric>

#include "runtime/core/module/end_kind_name.h"

namespace runtime {

bool ReturnStatistics::IsBest(const EpisodeRecord& episode) const {
  const Evaluation& active = episode.active;
  return active.end_kind != EndKindName(EndKind::kDiverged) &&
         std::isfinite(active.episode_return) && active.episode_return > best_;
}

void ReturnStatistics::Add(const EpisodeRecord& episode) {
  if (IsBest(episode)) {
    best_ = episode.active.episode_return;
    best_episode_ = episode.number;
  }
  if (last_returns_.size() == kMeanOver) last_returns_.erase(last_returns_.begin());
  last_returns_.push_back(episode.active.episode_return);
}

double ReturnStatistics::mean() const {
  if (last_returns_.empty()) return 0;
  return std::accumulate(last_returns_.begin(), last_returns_.end(), 0.0) /
         static_cast<double>(last_returns_.size());
}

}  // namespace runtime
