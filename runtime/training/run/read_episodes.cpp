#include "runtime/training/run/read_episodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "runtime/core/module/end_kind_name.h"
#include "runtime/training/run/table_reader.h"

namespace runtime {
namespace {

std::vector<EpisodeRecord> ReadHeads(const SqliteDatabase& database) {
  std::vector<EpisodeRecord> episodes;
  TableReader row(database, "episode",
                  "number, steps, actions, simulated_seconds, wall_seconds, cpu_seconds",
                  "ORDER BY number");
  while (row.Next()) {
    const auto next = static_cast<int64_t>(episodes.size()) + 1;
    EpisodeRecord& episode = episodes.emplace_back();
    episode.number = row.Whole(0, next, next);
    episode.steps = row.Whole(1, 0);
    episode.actions = row.Whole(2, 0);
    episode.simulated_seconds = row.Time(3);
    episode.wall_seconds = row.Time(4);
    episode.cpu_seconds = row.Time(5);
  }
  return episodes;
}

std::string ReadEndKind(TableReader& row, int column) {
  std::string kind = row.Text(column);
  if (EndKindCalled(kind)) return kind;
  row.FailAt(column, fmt::format("cannot be `{}`", kind));
}

// Takes over what each task says of the `episodes`.
void ReadEvaluations(const SqliteDatabase& database, int64_t task_count,
                     std::vector<EpisodeRecord>& episodes) {
  TableReader row(database, "evaluation",
                  "episode, task, is_active, return, end_kind, end_reason, faults, violations",
                  "ORDER BY episode, task");
  while (row.Next()) {
    const int64_t number = row.Whole(0, 1, static_cast<int64_t>(episodes.size()));
    EpisodeRecord& episode = episodes[static_cast<size_t>(number - 1)];
    Evaluation evaluation;
    evaluation.task = row.Whole(1, 1, task_count);
    const bool is_active = row.Flag(2);
    evaluation.episode_return = row.Real(3);
    evaluation.end_kind = ReadEndKind(row, 4);
    evaluation.end_reason = row.Text(5);
    evaluation.faults = row.Whole(6, 0);
    evaluation.violations = row.Whole(7, 0);
    if (!is_active) {
      episode.shadows.push_back(std::move(evaluation));
    } else if (episode.active.task == 0) {
      episode.active = std::move(evaluation);
    } else {
      row.FailAt(2, fmt::format("is 1 a second time in episode {}", number));
    }
  }
  for (const EpisodeRecord& episode : episodes) {
    if (episode.active.task != 0) continue;
    row.Fail(fmt::format("has no active task of episode {}", episode.number));
  }
}

// An evaluation by what its rows are ordered by.
struct EvaluationPlace {
  int64_t episode;
  Evaluation* evaluation;

  std::pair<int64_t, int64_t> key() const { return {episode, evaluation->task}; }
};

std::vector<EvaluationPlace> InTheOrderOfRows(std::vector<EpisodeRecord>& episodes) {
  std::vector<EvaluationPlace> places;
  for (EpisodeRecord& episode : episodes) {
    const auto first = static_cast<std::ptrdiff_t>(places.size());
    places.push_back({episode.number, &episode.active});
    for (Evaluation& shadow : episode.shadows) places.push_back({episode.number, &shadow});
    std::sort(places.begin() + first, places.end(),
              [](const auto& a, const auto& b) { return a.key() < b.key(); });
  }
  return places;
}

// A table of values, and where they belong.
struct ValueTable {
  const char* name;
  const char* column;
  std::vector<double> Evaluation::*values;
  size_t (*count)(const TaskRecord& task);
};
constexpr ValueTable kValueTables[] = {
    {"evaluation_term", "sum", &Evaluation::terms,
     [](const TaskRecord& task) { return task.terms.size(); }},
    {"evaluation_metric", "value", &Evaluation::metrics,
     [](const TaskRecord& task) { return task.metrics.size(); }},
    {"evaluation_log", "value", &Evaluation::logs,
     [](const TaskRecord& task) { return task.logs.size(); }},
};

void ReadValues(const SqliteDatabase& database, const ValueTable& table,
                const std::vector<TaskRecord>& tasks, const std::vector<EvaluationPlace>& places) {
  TableReader row(database, table.name, fmt::format("episode, task, id, {}", table.column),
                  "ORDER BY episode, task, id");
  auto place = places.begin();
  while (row.Next()) {
    const std::pair key(row.Whole(0, 1), row.Whole(1, 1));
    while (place != places.end() && place->key() < key) ++place;
    if (place == places.end() || place->key() != key) {
      row.FailAt(0, fmt::format("is {}, of which has nothing of task {}", key.first, key.second));
    }
    std::vector<double>& values = place->evaluation->*table.values;
    const auto next = static_cast<int64_t>(values.size());
    row.Whole(2, next, next);
    values.push_back(row.Real(3));
  }
  for (const auto& [episode, evaluation] : places) {
    const size_t wanted = table.count(tasks[static_cast<size_t>(evaluation->task - 1)]);
    const size_t found = (evaluation->*table.values).size();
    if (found == wanted) continue;
    row.Fail(fmt::format("has {} values of episode {} and task {}, which has {}", found, episode,
                         evaluation->task, wanted));
  }
}

}  // namespace

std::vector<EpisodeRecord> ReadEpisodes(const SqliteDatabase& database,
                                        const std::vector<TaskRecord>& tasks) {
  std::vector<EpisodeRecord> episodes = ReadHeads(database);
  ReadEvaluations(database, static_cast<int64_t>(tasks.size()), episodes);
  const std::vector<EvaluationPlace> places = InTheOrderOfRows(episodes);
  for (const ValueTable& table : kValueTables) ReadValues(database, table, tasks, places);
  return episodes;
}

}  // namespace runtime
