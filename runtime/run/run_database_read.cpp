#include <algorithm>
#include <charconv>
#include <utility>

#include "runtime/run/run_database_impl.h"

namespace runtime {
namespace {

// A number as `run` holds it.
template <class Number>
Number ParseNumber(const std::string& text) {
  Number number{};
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

std::vector<CurveRecord> ReadCurves(const SqliteDatabase& database, const char* query,
                                    int64_t task) {
  std::vector<CurveRecord> curves;
  SqliteStatement row(database, query, "read the run");
  row.Bind(task);
  while (row.Step()) curves.push_back({row.Text(0), row.Text(1), row.Text(2), row.Text(3)});
  return curves;
}

// What belongs to the task with this id.
void ReadParts(const SqliteDatabase& database, TaskRecord& task) {
  SqliteStatement term(database, "SELECT name, doc FROM term WHERE task = ? ORDER BY id",
                       "read the run");
  term.Bind(task.id);
  while (term.Step()) task.terms.push_back({term.Text(0), term.Text(1)});
  SqliteStatement source(database, "SELECT file, text FROM source WHERE task = ? ORDER BY id",
                         "read the run");
  source.Bind(task.id);
  while (source.Step()) task.sources.push_back({source.Text(0), source.Text(1)});
  task.metrics = ReadCurves(
      database, "SELECT name, unit, reduction, doc FROM metric WHERE task = ? ORDER BY id",
      task.id);
  task.logs = ReadCurves(
      database, "SELECT name, unit, reduction, doc FROM log WHERE task = ? ORDER BY id", task.id);
}

std::vector<TaskRecord> ReadTasks(const SqliteDatabase& database) {
  std::vector<TaskRecord> tasks;
  SqliteStatement row(database,
                      "SELECT id, module, name, file, hash, plugin, compiler FROM task ORDER BY id",
                      "read the run");
  while (row.Step()) {
    TaskRecord& task = tasks.emplace_back();
    task.id = row.Integer(0);
    task.module = row.Text(1);
    task.task = row.Text(2);
    task.task_file = row.Text(3);
    task.task_hash = row.Text(4);
    task.plugin = row.Text(5);
    task.compiler = row.Text(6);
    ReadParts(database, task);
  }
  return tasks;
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

// Takes over what each task says of the `episodes`, which are ascending.
void ReadEvaluations(const SqliteDatabase& database, std::vector<EpisodeRecord>& episodes) {
  SqliteStatement row(database,
                      "SELECT episode, task, is_active, return, end_kind, end_reason, faults, "
                      "violations FROM evaluation ORDER BY episode, task",
                      "read the episodes");
  auto episode = episodes.begin();
  while (row.Step()) {
    while (episode != episodes.end() && episode->number < row.Integer(0)) ++episode;
    if (episode == episodes.end()) return;  // added after they were read
    Evaluation& evaluation =
        row.Integer(2) != 0 ? episode->active : episode->shadows.emplace_back();
    evaluation.task = row.Integer(1);
    evaluation.episode_return = row.Real(3);
    evaluation.end_kind = row.Text(4);
    evaluation.end_reason = row.Text(5);
    evaluation.faults = row.Integer(6);
    evaluation.violations = row.Integer(7);
  }
}

// Appends the rows of `query`, episode, task and value in this order, to `member`.
void ReadValues(const SqliteDatabase& database, const char* query,
                const std::vector<EvaluationPlace>& places,
                std::vector<double> Evaluation::*member) {
  SqliteStatement row(database, query, "read the episodes");
  auto place = places.begin();
  while (row.Step()) {
    const std::pair key(row.Integer(0), row.Integer(1));
    while (place != places.end() && place->key() < key) ++place;
    if (place == places.end()) return;  // added after the episodes were read
    (place->evaluation->*member).push_back(row.Real(2));
  }
}

bool HasLearnerCurves(const SqliteDatabase& database) {
  return SqliteStatement(database, "SELECT 1 FROM sqlite_master WHERE name = 'learner_curve'",
                         "read the run")
      .Step();
}

// What the learner has shown of the `episodes`, which are ascending.
void ReadLearner(const SqliteDatabase& database, std::vector<EpisodeRecord>& episodes) {
  if (!HasLearnerCurves(database)) return;
  SqliteStatement row(
      database,
      "SELECT episode, name, value FROM learner_value JOIN learner_curve ON curve = "
      "id ORDER BY episode, curve",
      "read the episodes");
  auto episode = episodes.begin();
  while (row.Step()) {
    while (episode != episodes.end() && episode->number < row.Integer(0)) ++episode;
    if (episode == episodes.end()) return;  // added after they were read
    episode->learner.push_back({row.Text(1), row.Real(2)});
  }
}

}  // namespace

std::string RunDatabase::ReadValue(const std::string& key) const {
  SqliteStatement query(*impl_->database, "SELECT value FROM run WHERE key = ?", "read the run");
  return query.Bind(std::string_view(key)).Step() ? query.Text(0) : std::string();
}

RunRecord RunDatabase::ReadRun() const {
  RunRecord run;
  for (const TextKey& text : kTexts) run.*text.member = ReadValue(text.key);
  run.seed = ParseNumber<uint64_t>(ReadValue("seed"));
  run.episodes_planned = ParseNumber<int64_t>(ReadValue("episodes_planned"));
  run.record_every = ParseNumber<int64_t>(ReadValue("record_every"));
  run.checkpoint_seconds = ParseNumber<double>(ReadValue("checkpoint_seconds"));
  run.tasks = ReadTasks(*impl_->database);
  return run;
}

RunState RunDatabase::ReadState() const {
  const std::string state = ReadValue("state");
  if (state == RunStateName(RunState::kFinished)) return RunState::kFinished;
  const bool has_trainer = impl_->lock.has_value() || FolderLock::IsTaken(impl_->folder);
  return state == RunStateName(RunState::kRunning) && has_trainer ? RunState::kRunning
                                                                  : RunState::kInterrupted;
}

std::vector<EpisodeRecord> RunDatabase::ReadEpisodes() const {
  const SqliteDatabase& database = *impl_->database;
  std::vector<EpisodeRecord> episodes;
  SqliteStatement query(
      database,
      "SELECT number, steps, actions, simulated_seconds, wall_seconds, cpu_seconds "
      "FROM episode ORDER BY number",
      "read the episodes");
  while (query.Step()) {
    EpisodeRecord& episode = episodes.emplace_back();
    episode.number = query.Integer(0);
    episode.steps = query.Integer(1);
    episode.actions = query.Integer(2);
    episode.simulated_seconds = query.Real(3);
    episode.wall_seconds = query.Real(4);
    episode.cpu_seconds = query.Real(5);
  }
  ReadEvaluations(database, episodes);
  const std::vector<EvaluationPlace> places = InTheOrderOfRows(episodes);
  ReadValues(database, "SELECT episode, task, sum FROM evaluation_term ORDER BY episode, task, id",
             places, &Evaluation::terms);
  ReadValues(database,
             "SELECT episode, task, value FROM evaluation_metric ORDER BY episode, task, id",
             places, &Evaluation::metrics);
  ReadValues(database, "SELECT episode, task, value FROM evaluation_log ORDER BY episode, task, id",
             places, &Evaluation::logs);
  ReadLearner(database, episodes);
  return episodes;
}

std::vector<CurveRecord> RunDatabase::ReadLearnerCurves() const {
  std::vector<CurveRecord> curves;
  if (!HasLearnerCurves(*impl_->database)) return curves;
  SqliteStatement row(*impl_->database, "SELECT name, unit, doc FROM learner_curve ORDER BY id",
                      "read the learner's curves");
  while (row.Step()) curves.push_back({row.Text(0), row.Text(1), "", row.Text(2)});
  return curves;
}

std::vector<ChangeRecord> RunDatabase::ReadChanges() const {
  std::vector<ChangeRecord> changes;
  SqliteStatement row(*impl_->database,
                      "SELECT id, episode, step, at, kind, text, data FROM change ORDER BY id",
                      "read the changes");
  while (row.Step()) {
    changes.push_back({row.Integer(0), row.Integer(1), row.Integer(2), row.Text(3), row.Text(4),
                       row.Text(5), row.Text(6)});
  }
  return changes;
}

std::optional<Checkpoint> RunDatabase::ReadCheckpoint() const {
  SqliteStatement query(*impl_->database, "SELECT episode, state FROM checkpoint",
                        "read the checkpoint");
  if (!query.Step()) return std::nullopt;
  return Checkpoint{query.Integer(0), query.Blob(1)};
}

int64_t RunDatabase::ReadCheckpointEpisode() const {
  return impl_->database->QueryInteger("SELECT max(episode) FROM checkpoint",
                                       "read the checkpoint");
}

int64_t RunDatabase::ReadLastRecordedEpisode() const {
  return impl_->database->QueryInteger("SELECT max(episode) FROM recording", "read the recordings");
}

std::vector<int64_t> RunDatabase::ReadRecordedEpisodes() const {
  SqliteStatement query(*impl_->database, "SELECT episode FROM recording ORDER BY episode",
                        "read the recordings");
  std::vector<int64_t> episodes;
  while (query.Step()) episodes.push_back(query.Integer(0));
  return episodes;
}

std::optional<Recording> RunDatabase::ReadRecording(int64_t episode) const {
  SqliteStatement query(
      *impl_->database,
      "SELECT frames, frame_interval, is_best, poses FROM recording WHERE episode = ?",
      "read a recording");
  if (!query.Bind(episode).Step()) return std::nullopt;
  return Recording{query.Integer(0), query.Real(1), query.Integer(2) != 0, query.Blob(3)};
}

}  // namespace runtime
