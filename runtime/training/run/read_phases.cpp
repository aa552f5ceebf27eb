#include "runtime/training/run/read_phases.h"

#include <fmt/format.h>

#include "runtime/training/run/table_reader.h"

namespace runtime {
namespace {

void ReadRows(const SqliteDatabase& database, const std::vector<TaskRecord>& tasks,
              std::vector<EpisodeRecord>& episodes) {
  TableReader row(database, "evaluation_phase", "episode, task, phase, time, return",
                  "ORDER BY episode, task, phase");
  while (row.Next()) {
    const int64_t number = row.Whole(0, 1, static_cast<int64_t>(episodes.size()));
    const int64_t task = row.Whole(1, 1, static_cast<int64_t>(tasks.size()));
    Evaluation* evaluation = FindEvaluation(episodes[static_cast<size_t>(number - 1)], task);
    if (evaluation == nullptr) row.FailAt(1, "is of a task that did not run in the episode");
    const auto next = static_cast<int64_t>(evaluation->phases.size());
    row.Whole(2, next, next);
    evaluation->phases.push_back({row.Time(3), row.Real(4)});
  }
}

void Check(const SqliteDatabase& database, const Evaluation& evaluation,
           const std::vector<TaskRecord>& tasks) {
  const size_t wanted = tasks[static_cast<size_t>(evaluation.task - 1)].phases.size();
  if (evaluation.phases.size() == wanted) return;
  ThrowDamaged(database,
               fmt::format("the table `evaluation_phase` has {} phases of an episode of task {}, "
                           "which has {}",
                           evaluation.phases.size(), evaluation.task, wanted));
}

}  // namespace

void ReadPhases(const SqliteDatabase& database, std::vector<TaskRecord>& tasks) {
  if (!HasTable(database, "phase")) return;
  TableReader row(database, "phase", "task, id, name, doc", "ORDER BY task, id");
  while (row.Next()) {
    const int64_t task = row.Whole(0, 1, static_cast<int64_t>(tasks.size()));
    std::vector<PhaseRecord>& phases = tasks[static_cast<size_t>(task - 1)].phases;
    const auto next = static_cast<int64_t>(phases.size());
    row.Whole(1, next, next);
    phases.push_back({row.Name(2), row.Text(3)});
  }
}

void ReadPhaseSums(const SqliteDatabase& database, const std::vector<TaskRecord>& tasks,
                   std::vector<EpisodeRecord>& episodes) {
  if (HasTable(database, "evaluation_phase")) ReadRows(database, tasks, episodes);
  for (const EpisodeRecord& episode : episodes) {
    Check(database, episode.active, tasks);
    for (const Evaluation& shadow : episode.shadows) Check(database, shadow, tasks);
  }
}

}  // namespace runtime
