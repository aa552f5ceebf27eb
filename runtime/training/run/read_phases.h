// What a run's database says of phases; nothing where an older version wrote it.
#pragma once

#include <vector>

#include "runtime/training/run/run_records.h"
#include "runtime/training/run/sqlite.h"

namespace runtime {

// Adds the phases of each task. Throws UserError if the database is damaged, and so does the other.
void ReadPhases(const SqliteDatabase& database, std::vector<TaskRecord>& tasks);
// Adds what each phase was to each evaluation of the episodes, which are numbered from 1.
void ReadPhaseSums(const SqliteDatabase& database, const std::vector<TaskRecord>& tasks,
                   std::vector<EpisodeRecord>& episodes);

}  // namespace runtime
