// The episodes of a run with all their values, from its database.
#pragma once

#include <vector>

#include "runtime/training/run/run_records.h"
#include "runtime/training/run/sqlite.h"

namespace runtime {

// In their order, which is 1, 2, ...; each with one active evaluation, and each evaluation with a
// value for each term, metric and log of its task, which is one of `tasks`. Throws UserError where
// the database says otherwise.
std::vector<EpisodeRecord> ReadEpisodes(const SqliteDatabase& database,
                                        const std::vector<TaskRecord>& tasks);

}  // namespace runtime
