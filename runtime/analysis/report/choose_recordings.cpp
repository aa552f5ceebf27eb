#include "runtime/analysis/report/choose_recordings.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace runtime {
namespace {

// How many episodes lie between `entry` and the nearest of those chosen.
int64_t DistanceToChosen(const std::vector<RecordingEntry>& entries,
                         const std::vector<size_t>& chosen, size_t entry) {
  int64_t distance = std::numeric_limits<int64_t>::max();
  for (const size_t other : chosen) {
    distance = std::min(distance, std::abs(entries[entry].episode - entries[other].episode));
  }
  return distance;
}

}  // namespace

size_t BestRecording(const std::vector<RecordingEntry>& entries) {
  const auto is_worse = [](const RecordingEntry& a, const RecordingEntry& b) {
    // A return that is not a number is worse than any.
    return !(a.episode_return >= b.episode_return) && b.episode_return == b.episode_return;
  };
  return static_cast<size_t>(std::max_element(entries.begin(), entries.end(), is_worse) -
                             entries.begin());
}

std::vector<size_t> ChooseRecordings(const std::vector<RecordingEntry>& entries, size_t budget,
                                     size_t max_count) {
  if (entries.empty()) return {};
  std::vector<size_t> chosen = {BestRecording(entries)};
  size_t size = entries[chosen.front()].size;
  const auto add = [&](size_t entry) {
    const bool is_there = std::find(chosen.begin(), chosen.end(), entry) != chosen.end();
    if (is_there || size + entries[entry].size > budget || chosen.size() >= max_count) return false;
    chosen.push_back(entry);
    size += entries[entry].size;
    return true;
  };
  add(entries.size() - 1);
  add(0);
  for (bool is_added = true; is_added;) {
    size_t farthest = 0;
    for (size_t i = 1; i < entries.size(); ++i) {
      if (DistanceToChosen(entries, chosen, i) > DistanceToChosen(entries, chosen, farthest)) {
        farthest = i;
      }
    }
    is_added = add(farthest);
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

}  // namespace runtime
