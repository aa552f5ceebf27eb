// The tasks of a run with all their parts, from its database.
#pragma once

#include <vector>

#include "runtime/training/run/run_records.h"
#include "runtime/training/run/sqlite.h"

namespace runtime {

// In the order of their ids, which are 1, 2, ...; at least one, each with its own text. Throws
// UserError where the database says otherwise.
std::vector<TaskRecord> ReadTasks(const SqliteDatabase& database);

}  // namespace runtime
