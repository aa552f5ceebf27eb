// What the returns of a run's episodes are, without the rest that RunDatabase::ReadEpisodes()
// reads: for those who look again and again while the run is trained.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace runtime {

struct EpisodeReturn {
  int64_t episode = 0;  // from 1
  double value = 0;     // of the task that was active; not a number where it was not finite
  bool has_diverged = false;
  double simulated_seconds = 0;
  double wall_seconds = 0;
};

// Of the episodes after `episode`, ascending. Throws UserError where the run cannot be read.
std::vector<EpisodeReturn> ReadReturns(const std::filesystem::path& folder, int64_t episode);

}  // namespace runtime
