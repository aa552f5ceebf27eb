#include "runtime/training/run/read_returns.h"

#include "runtime/core/module/end_kind_name.h"
#include "runtime/training/run/run_files.h"
#include "runtime/training/run/run_records.h"
#include "runtime/training/run/sqlite.h"
#include "runtime/training/run/table_reader.h"

namespace runtime {

std::vector<EpisodeReturn> ReadReturns(const std::filesystem::path& folder, int64_t episode) {
  const SqliteDatabase database(RunDatabaseFile(folder), SqliteAccess::kRead);
  TableReader row(database, "episode", "number, return, end_kind, simulated_seconds, wall_seconds",
                  "JOIN evaluation ON evaluation.episode = number AND is_active = 1 "
                  "WHERE number > ? ORDER BY number");
  row.Bind(episode);
  std::vector<EpisodeReturn> returns;
  while (row.Next()) {
    returns.push_back({.episode = row.Whole(0, 1),
                       .value = row.Real(1),
                       .has_diverged = row.Text(2) == EndKindName(EndKind::kDiverged),
                       .simulated_seconds = row.Time(3),
                       .wall_seconds = row.Time(4)});
  }
  return returns;
}

}  // namespace runtime
