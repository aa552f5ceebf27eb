#include "runtime/training/run/read_goals.h"

#include "runtime/training/run/table_reader.h"
#include "runtime/training/run/value_json.h"

namespace runtime {
void ReadGoals(const SqliteDatabase& database, std::vector<TaskRecord>& tasks) {
  if (!HasTable(database, "goal")) return;
  TableReader row(database, "goal", "task, id, name, type, unit, doc", "ORDER BY task, id");
  while (row.Next()) {
    const int64_t task = row.Whole(0, 1, static_cast<int64_t>(tasks.size()));
    std::vector<GoalRecord>& goals = tasks[static_cast<size_t>(task - 1)].goals;
    const auto next = static_cast<int64_t>(goals.size());
    row.Whole(1, next, next);
    goals.push_back({row.Name(2), row.Name(3), row.Text(4), row.Text(5)});
  }
}

void ReadGoalDraws(const SqliteDatabase& database, const std::vector<TaskRecord>& tasks,
                   std::vector<EpisodeRecord>& episodes) {
  if (!HasTable(database, "evaluation_goal")) return;
  TableReader row(database, "evaluation_goal", "episode, task, number, goal, time, value",
                  "ORDER BY episode, task, number");
  while (row.Next()) {
    const int64_t number = row.Whole(0, 1, static_cast<int64_t>(episodes.size()));
    const int64_t task = row.Whole(1, 1, static_cast<int64_t>(tasks.size()));
    Evaluation* evaluation = FindEvaluation(episodes[static_cast<size_t>(number - 1)], task);
    if (evaluation == nullptr) row.FailAt(1, "is of a task that did not run in the episode");
    const auto next = static_cast<int64_t>(evaluation->goals.size());
    row.Whole(2, next, next);
    const auto last = static_cast<int64_t>(tasks[static_cast<size_t>(task - 1)].goals.size()) - 1;
    const int64_t goal = row.Whole(3, 0, last);
    auto value = ParseNumbers(row.Text(5));
    if (!value) row.FailAt(5, "is no list of numbers");
    evaluation->goals.push_back({static_cast<size_t>(goal), row.Time(4), std::move(*value)});
  }
}

}  // namespace runtime
