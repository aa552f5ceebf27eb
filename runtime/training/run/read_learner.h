// What the learner of a run has shown of itself, from the run's database.
#pragma once

#include <vector>

#include "runtime/training/run/run_records.h"
#include "runtime/training/run/sqlite.h"

namespace runtime {

// In the order in which it shows them; none in a run from before there were any. Throws UserError
// where the database says what no trainer has written, and so does the next one.
std::vector<CurveRecord> ReadLearnerCurves(const SqliteDatabase& database);

// Adds what it has shown of the `episodes`, which are 1, 2, ...
void ReadLearnerValues(const SqliteDatabase& database, std::vector<EpisodeRecord>& episodes);

}  // namespace runtime
