// Which of the recorded episodes the page can carry.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace runtime {

struct RecordingEntry {
  int64_t episode = 0;
  double episode_return = 0;
  size_t size = 0;  // in the page [bytes]
};

// Indices of at most `max_count` of `entries` (ascending by episode) whose sizes sum to at most
// `budget`: the best one, the last, the first, then always the one farthest from those chosen, so
// that they spread over the run. The best one is chosen whatever its size. Ascending.
std::vector<size_t> ChooseRecordings(const std::vector<RecordingEntry>& entries, size_t budget,
                                     size_t max_count);

// The index of the entry with the highest return; `entries` is not empty.
size_t BestRecording(const std::vector<RecordingEntry>& entries);

}  // namespace runtime
