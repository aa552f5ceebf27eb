#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

#include "base/text/utf8.h"
#include "runtime/base/user_error.h"
#include "runtime/training/run/body_json.h"
#include "runtime/training/run/change_json.h"
#include "runtime/training/run/read_episodes.h"
#include "runtime/training/run/read_goals.h"
#include "runtime/training/run/read_learner.h"
#include "runtime/training/run/read_phases.h"
#include "runtime/training/run/read_tasks.h"
#include "runtime/training/run/run_database_impl.h"
#include "runtime/training/run/sealed_state.h"
#include "runtime/training/run/table_reader.h"

namespace runtime {
namespace {

// What several statements read is of one moment, also while a trainer writes.
class Moment {
 public:
  explicit Moment(SqliteDatabase& database) : database_(database) {
    database_.Execute("BEGIN", "read the run");
  }
  Moment(const Moment&) = delete;
  Moment& operator=(const Moment&) = delete;
  ~Moment() { sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr); }

 private:
  SqliteDatabase& database_;
};

// Of a row of the table `change`.
Change ChangeIn(TableReader& row, int64_t task_count) {
  const std::string kind = row.Name(4);
  const std::string data = row.Text(6);
  try {
    return ReadChange(kind, data, task_count);
  } catch (const UserError& error) {
    row.FailAt(6, error.what());
  }
}

// The table `run`.
class RunValues {
 public:
  explicit RunValues(const SqliteDatabase& database) : database_(database) {
    TableReader row(database, "run", "key, value", "ORDER BY key");
    while (row.Next()) {
      const std::string key = row.Name(0);
      if (!values_.try_emplace(key, row.Text(1)).second) row.FailAt(0, "occurs twice");
    }
  }

  std::string Find(const std::string& key) const {  // "" if there is none
    const auto found = values_.find(key);
    return found == values_.end() ? std::string() : found->second;
  }

  const std::string& Text(const std::string& key) const {
    const auto found = values_.find(key);
    if (found == values_.end()) Fail(fmt::format("has no `{}`", key));
    // It goes on into JSON, which has no other texts.
    if (!text::IsUtf8(found->second)) Fail(fmt::format("has a `{}` that is not UTF-8", key));
    return found->second;
  }

  template <class Number>
  Number NotNegative(const std::string& key) const {
    const std::string& text = Text(key);
    const char* const end = text.data() + text.size();
    Number number{};
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    const bool is_number = error == std::errc() && rest == end && number >= Number{0};
    if (!is_number) Fail(fmt::format("says that `{}` is `{:.40}`", key, text));
    return number;
  }

  RunState State() const {
    const std::string& state = Text("state");
    for (const RunState each : {RunState::kRunning, RunState::kInterrupted, RunState::kFinished}) {
      if (state == RunStateName(each)) return each;
    }
    Fail(fmt::format("says that `state` is `{:.40}`", state));
  }

  [[noreturn]] void Fail(std::string_view what) const {
    ThrowDamaged(database_, fmt::format("the table `run` {}", what));
  }

 private:
  const SqliteDatabase& database_;
  std::map<std::string, std::string> values_;
};

// "" where there is none.
std::string TimelineIn(const SqliteDatabase& database, int64_t episode) {
  if (!HasTable(database, "timeline")) return "";
  TableReader row(database, "timeline", "samples", "WHERE episode = ?");
  row.Bind(episode);
  return row.Next() ? row.Blob(0) : "";
}

RunRecord RunIn(const SqliteDatabase& database) {
  const RunValues values(database);
  RunRecord run;
  for (const TextKey& text : kTexts) run.*text.member = values.Text(text.key);
  run.seed = values.NotNegative<uint64_t>("seed");
  run.episodes_planned = values.NotNegative<int64_t>("episodes_planned");
  run.record_every = values.NotNegative<int64_t>("record_every");
  run.checkpoint_seconds = values.NotNegative<double>("checkpoint_seconds");
  if (!ParseBody(run.body)) values.Fail("has a `body` that is not valid");
  run.tasks = ReadTasks(database);
  return run;
}

std::vector<EpisodeRecord> EpisodesIn(const SqliteDatabase& database,
                                      const std::vector<TaskRecord>& tasks) {
  std::vector<EpisodeRecord> episodes = ReadEpisodes(database, tasks);
  ReadGoalDraws(database, tasks, episodes);
  ReadPhaseSums(database, tasks, episodes);
  ReadLearnerValues(database, episodes);
  return episodes;
}

int64_t LastEpisode(SqliteDatabase& database) {
  return database.QueryInteger("SELECT max(number) FROM episode", "read the episodes");
}

}  // namespace

std::string RunDatabase::ReadValue(const std::string& key) const {
  return RunValues(*impl_->database).Find(key);
}

RunRecord RunDatabase::ReadRun() const {
  const Moment moment(*impl_->database);
  return RunIn(*impl_->database);
}

RunAndEpisodes RunDatabase::ReadRunAndEpisodes() const {
  const Moment moment(*impl_->database);
  RunRecord run = RunIn(*impl_->database);
  std::vector<EpisodeRecord> episodes = EpisodesIn(*impl_->database, run.tasks);
  return {std::move(run), std::move(episodes)};
}

RunState RunDatabase::ReadState() const {
  const RunState state = RunValues(*impl_->database).State();
  if (state == RunState::kFinished) return state;
  const bool has_trainer = impl_->lock.has_value() || FolderLock::IsTaken(impl_->folder);
  return state == RunState::kRunning && has_trainer ? state : RunState::kInterrupted;
}

std::vector<EpisodeRecord> RunDatabase::ReadEpisodes() const {
  const Moment moment(*impl_->database);
  return EpisodesIn(*impl_->database, ReadTasks(*impl_->database));
}

std::vector<CurveRecord> RunDatabase::ReadLearnerCurves() const {
  return runtime::ReadLearnerCurves(*impl_->database);
}

std::vector<ChangeRecord> RunDatabase::ReadChanges() const {
  const Moment moment(*impl_->database);
  const int64_t task_count =
      impl_->database->QueryInteger("SELECT count(*) FROM task", "read the tasks");
  std::vector<ChangeRecord> changes;
  TableReader row(*impl_->database, "change", "id, episode, step, at, kind, text, data",
                  "ORDER BY id");
  while (row.Next()) {
    const int64_t after = changes.empty() ? 0 : changes.back().id;
    changes.push_back({row.Whole(0, after + 1), row.Whole(1, 1),
                       row.Whole(2, 0, std::numeric_limits<int64_t>::max()), row.Text(3),
                       ChangeIn(row, task_count), row.Text(5)});
  }
  return changes;
}

std::optional<Checkpoint> RunDatabase::ReadCheckpoint() const {
  const Moment moment(*impl_->database);
  TableReader row(*impl_->database, "checkpoint", "episode, state", "");
  if (!row.Next()) return std::nullopt;
  const int64_t episode = row.Whole(0, 1);
  std::optional<std::string> state = UnsealState(episode, row.Blob(1));
  if (!state) {
    throw UserError(fmt::format(
        "{}: the checkpoint after episode {} is damaged: it is not what was saved, so the run "
        "cannot continue or be evaluated; restore a copy of the file, or start another run; "
        "`trainer "
        "show` and `trainer report` still read what it has recorded",
        impl_->database->file().string(), episode));
  }
  if (episode > LastEpisode(*impl_->database))
    row.FailAt(0, "is of an episode that does not exist");
  return Checkpoint{episode, *std::move(state)};
}

int64_t RunDatabase::ReadCheckpointEpisode() const {
  return impl_->database->QueryInteger("SELECT max(episode) FROM checkpoint",
                                       "read the checkpoint");
}

int64_t RunDatabase::ReadLastRecordedEpisode() const {
  const std::vector<RecordedEpisode> recorded = ReadRecordedEpisodes();
  return recorded.empty() ? 0 : recorded.back().number;
}

std::vector<RecordedEpisode> RunDatabase::ReadRecordedEpisodes() const {
  const Moment moment(*impl_->database);
  const int64_t last = LastEpisode(*impl_->database);
  std::vector<RecordedEpisode> episodes;
  TableReader row(*impl_->database, "recording", "episode, frames", "ORDER BY episode");
  while (row.Next()) {
    const int64_t after = episodes.empty() ? 0 : episodes.back().number;
    episodes.push_back({row.Whole(0, after + 1, last), row.Whole(1, 1, Recording::kMostFrames)});
  }
  return episodes;
}

std::optional<Recording> RunDatabase::ReadRecording(int64_t episode) const {
  constexpr double kShortest = 1e-9;
  TableReader row(*impl_->database, "recording", "frames, frame_interval, is_best, poses",
                  "WHERE episode = ?");
  row.Bind(episode);
  if (!row.Next()) return std::nullopt;
  return Recording{row.Whole(0, 1, Recording::kMostFrames), row.Time(1, kShortest), row.Flag(2),
                   row.Blob(3), TimelineIn(*impl_->database, episode)};
}

}  // namespace runtime
