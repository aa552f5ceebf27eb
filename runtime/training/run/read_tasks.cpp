#include "runtime/training/run/read_tasks.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/training/run/read_goals.h"
#include "runtime/training/run/read_phases.h"
#include "runtime/training/run/table_reader.h"

namespace runtime {
namespace {

// Of each task, in their order.
std::vector<TaskRecord> ReadTaskHeads(const SqliteDatabase& database) {
  std::vector<TaskRecord> tasks;
  TableReader row(database, "task", "id, module, name, file, hash, plugin, compiler",
                  "ORDER BY id");
  while (row.Next()) {
    const auto next = static_cast<int64_t>(tasks.size()) + 1;
    TaskRecord& task = tasks.emplace_back();
    task.id = row.Whole(0, next, next);
    task.module = row.Name(1);
    task.task = row.Name(2);
    task.task_file = row.Name(3);
    task.task_hash = row.Text(4);
    task.plugin = row.Text(5);
    task.compiler = row.Text(6);
  }
  if (tasks.empty()) row.Fail("is empty");
  return tasks;
}

// Appends what `read` makes of each row of `table` to `member` of its task; the rows of a task are
// numbered from 0.
template <class Part, class Read>
void ReadParts(const SqliteDatabase& database, const char* table, const char* columns,
               std::vector<Part> TaskRecord::*member, std::vector<TaskRecord>& tasks, Read read) {
  TableReader row(database, table, fmt::format("task, id, {}", columns), "ORDER BY task, id");
  while (row.Next()) {
    const int64_t task = row.Whole(0, 1, static_cast<int64_t>(tasks.size()));
    std::vector<Part>& parts = tasks[static_cast<size_t>(task - 1)].*member;
    const auto next = static_cast<int64_t>(parts.size());
    row.Whole(1, next, next);
    parts.push_back(read(row));
  }
}

std::string ReadReduction(TableReader& row, int column) {
  constexpr const char* kReductions[] = {"last", "sum", "max", "min", "mean"};
  const std::string reduction = row.Text(column);
  if (std::ranges::find(kReductions, reduction) == std::end(kReductions)) {
    row.FailAt(column, fmt::format("cannot be `{}`", reduction));
  }
  return reduction;
}

void ReadCurves(const SqliteDatabase& database, const char* table,
                std::vector<CurveRecord> TaskRecord::*member, std::vector<TaskRecord>& tasks) {
  ReadParts(database, table, "name, unit, reduction, doc", member, tasks, [](TableReader& row) {
    return CurveRecord{row.Name(2), row.Text(3), ReadReduction(row, 4), row.Text(5)};
  });
}

}  // namespace

std::vector<TaskRecord> ReadTasks(const SqliteDatabase& database) {
  std::vector<TaskRecord> tasks = ReadTaskHeads(database);
  ReadParts(database, "source", "file, text", &TaskRecord::sources, tasks, [](TableReader& row) {
    return SourceRecord{row.Name(2), row.Text(3)};
  });
  ReadParts(database, "term", "name, doc", &TaskRecord::terms, tasks, [](TableReader& row) {
    return TermRecord{row.Name(2), row.Text(3)};
  });
  ReadCurves(database, "metric", &TaskRecord::metrics, tasks);
  ReadCurves(database, "log", &TaskRecord::logs, tasks);
  ReadGoals(database, tasks);
  ReadPhases(database, tasks);
  for (const TaskRecord& task : tasks) {
    if (!task.sources.empty()) continue;
    ThrowDamaged(database, fmt::format("the table `source` has no text of task {}", task.id));
  }
  return tasks;
}

}  // namespace runtime
