#include "runtime/training/run/machine_record.h"

#include <string>
#include <string_view>

#include "runtime/training/run/run_files.h"
#include "runtime/training/run/sqlite.h"
#include "runtime/training/run/table_reader.h"

namespace runtime {
namespace {

constexpr const char* kNoting = "note the machine";

std::vector<MachineRecord> ReadTable(const SqliteDatabase& database) {
  std::vector<MachineRecord> machines;
  if (!HasTable(database, "machine")) return machines;
  TableReader row(database, "machine", "episode, facts", "ORDER BY episode");
  while (row.Next()) machines.push_back({row.Whole(0, 1), ParseMachine(row.Text(1))});
  return machines;
}

}  // namespace

std::vector<MachineRecord> ReadMachines(const std::filesystem::path& folder) {
  return ReadTable(SqliteDatabase(RunDatabaseFile(folder), SqliteAccess::kRead));
}

MachineFacts FactsAt(const std::vector<MachineRecord>& machines, int64_t episode) {
  MachineFacts facts;
  for (const MachineRecord& machine : machines) {
    if (machine.episode <= episode) facts = machine.facts;
  }
  return facts;
}

void SetMachine(const std::filesystem::path& folder, const MachineRecord& machine) {
  SqliteDatabase database(RunDatabaseFile(folder), SqliteAccess::kWrite);
  SqliteTransaction transaction(database, kNoting);
  SqliteStatement(database, "DELETE FROM machine WHERE episode >= ?", kNoting)
      .Bind(machine.episode)
      .Run();
  const std::vector<MachineRecord> before = ReadTable(database);
  if (before.empty() || before.back().facts != machine.facts) {
    const std::string facts = MachineText(machine.facts);
    SqliteStatement(database, "INSERT INTO machine VALUES (?, ?)", kNoting)
        .Bind(machine.episode, std::string_view(facts))
        .Run();
  }
  transaction.Commit();
}

}  // namespace runtime
