// Every number that a run's record says of its episodes, as a table.
#pragma once

#include <string>
#include <vector>

#include "runtime/training/run/run_database.h"

namespace runtime {

struct EpisodeColumn {
  // "return", "simulated [s]", "term/forward", "metric/distance [m]", "learner/kl": what it is of,
  // its name and its unit. No two columns have the same.
  std::string name;
  std::vector<double> values;  // one for each episode; not a number where there is none
};

struct EpisodeTable {
  std::vector<EpisodeRecord> episodes;  // ascending
  std::vector<EpisodeColumn> columns;
  // When each episode ended, in seconds since 1970, as if the trainer had never been interrupted.
  std::vector<double> end_times;
};

// Throws UserError where the database cannot be read.
EpisodeTable ReadEpisodeTable(const RunDatabase& database);

}  // namespace runtime
