#include <charconv>
#include <map>

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

std::vector<CurveRecord> ReadCurves(const SqliteDatabase& database, const char* query) {
  std::vector<CurveRecord> curves;
  SqliteStatement row(database, query, "read the run");
  while (row.Step()) curves.push_back({row.Text(0), row.Text(1), row.Text(2), row.Text(3)});
  return curves;
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
  SqliteStatement term(*impl_->database, "SELECT name, doc FROM term ORDER BY id", "read the run");
  while (term.Step()) run.terms.push_back({term.Text(0), term.Text(1)});
  SqliteStatement source(*impl_->database, "SELECT file, text FROM source ORDER BY id",
                         "read the run");
  while (source.Step()) run.sources.push_back({source.Text(0), source.Text(1)});
  run.metrics =
      ReadCurves(*impl_->database, "SELECT name, unit, reduction, doc FROM metric ORDER BY id");
  run.logs = ReadCurves(*impl_->database, "SELECT name, unit, reduction, doc FROM log ORDER BY id");
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
  std::vector<EpisodeRecord> episodes;
  std::map<int64_t, size_t> index;
  SqliteStatement query(
      *impl_->database,
      "SELECT number, return, end_kind, end_reason, steps, actions, "
      "simulated_seconds, wall_seconds, faults, violations FROM episode ORDER BY number",
      "read the episodes");
  while (query.Step()) {
    EpisodeRecord& episode = episodes.emplace_back();
    episode.number = query.Integer(0);
    episode.episode_return = query.Real(1);
    episode.end_kind = query.Text(2);
    episode.end_reason = query.Text(3);
    episode.steps = query.Integer(4);
    episode.actions = query.Integer(5);
    episode.simulated_seconds = query.Real(6);
    episode.wall_seconds = query.Real(7);
    episode.faults = query.Integer(8);
    episode.violations = query.Integer(9);
    index[episode.number] = episodes.size() - 1;
  }
  SqliteStatement term(*impl_->database,
                       "SELECT episode, sum FROM episode_term ORDER BY episode, term",
                       "read the episodes");
  SqliteStatement metric(*impl_->database,
                         "SELECT episode, value FROM episode_metric ORDER BY episode, metric",
                         "read the episodes");
  SqliteStatement log(*impl_->database,
                      "SELECT episode, value FROM episode_log ORDER BY episode, log",
                      "read the episodes");
  // A row whose episode was added after the first query belongs to none of these.
  const auto read = [&](SqliteStatement& values, std::vector<double> EpisodeRecord::*member) {
    while (values.Step()) {
      const auto found = index.find(values.Integer(0));
      if (found != index.end()) (episodes[found->second].*member).push_back(values.Real(1));
    }
  };
  read(term, &EpisodeRecord::terms);
  read(metric, &EpisodeRecord::metrics);
  read(log, &EpisodeRecord::logs);
  return episodes;
}

std::optional<Checkpoint> RunDatabase::ReadCheckpoint() const {
  SqliteStatement query(*impl_->database, "SELECT episode, state FROM checkpoint",
                        "read the checkpoint");
  if (!query.Step()) return std::nullopt;
  return Checkpoint{query.Integer(0), query.Blob(1)};
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
