#include "runtime/training/run/run_database.h"

#include <fmt/format.h>
#include <sys/vfs.h>

#include "runtime/training/run/change_json.h"
#include "runtime/training/run/iso_time.h"
#include "runtime/training/run/record_error.h"
#include "runtime/training/run/run_database_impl.h"
#include "runtime/training/run/run_files.h"
#include "runtime/training/run/run_schema.h"
#include "runtime/training/run/sealed_state.h"
#include "runtime/training/run/value_json.h"

namespace runtime {
namespace {

constexpr int kSchemaVersion = 3;
constexpr int kApplicationId = 0x74736b63;  // "tskc"

constexpr const char* kOpening = "open the run";
constexpr const char* kMaking = "make the run";

std::span<const std::byte> Bytes(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

void CheckSchema(SqliteDatabase& database) {
  const std::string file = database.file().string();
  if (database.QueryInteger("PRAGMA application_id", kOpening) != kApplicationId) {
    throw UserError(fmt::format(
        "{}: this is a database, but not one of the trainer; name the folder of a run", file));
  }
  const int64_t version = database.QueryInteger("PRAGMA user_version", kOpening);
  if (version != kSchemaVersion) {
    throw UserError(fmt::format(
        "{}: the run was written by another version of the trainer (its schema is {}, ours is {}); "
        "use that version",
        file, version, kSchemaVersion));
  }
}

FolderLock TakeLock(const std::filesystem::path& folder) {
  std::optional<FolderLock> lock = FolderLock::Take(folder);
  if (!lock) {
    throw UserError(fmt::format(
        "{}: another trainer works on this run, or the folder cannot be opened; wait for it, stop "
        "it, or use another folder",
        folder.string()));
  }
  return std::move(*lock);
}

// A kill may leave the journal of a change to the whole file, such as that to another way of
// writing it. Whoever writes takes that back by looking; whoever reads cannot, and so lets it be
// done first.
void TakeBackHalfAChange(const std::filesystem::path& file) {
  std::filesystem::path journal = file;
  if (!std::filesystem::exists(journal += "-journal")) return;
  SqliteDatabase(file, SqliteAccess::kWrite).QueryInteger("PRAGMA user_version", kOpening);
}

std::unique_ptr<SqliteDatabase> OpenChecked(const std::filesystem::path& folder,
                                            SqliteAccess access) {
  if (!RunDatabase::Exists(folder)) {
    throw UserError(
        fmt::format("{}: there is no run in this folder; `trainer train TASK --out {}` starts one",
                    folder.string(), folder.string()));
  }
  if (access == SqliteAccess::kRead) TakeBackHalfAChange(RunDatabaseFile(folder));
  auto database = std::make_unique<SqliteDatabase>(RunDatabaseFile(folder), access);
  CheckSchema(*database);
  return database;
}

// Whether other machines may see the file: their file systems by what statfs() calls them.
bool IsShared(const std::filesystem::path& file) {
  struct statfs system {};
  if (statfs(file.c_str(), &system) != 0) return false;
  switch (static_cast<uint32_t>(system.f_type)) {
    case 0x6969:      // NFS
    case 0xFF534D42:  // CIFS
    case 0xFE534D42:  // SMB
    case 0x0BD00BD0:  // Lustre
    case 0x47504653:  // GPFS
    case 0x19830326:  // BeeGFS
    case 0x00C36400:  // Ceph
    case 0x01161970:  // GFS2
    case 0x65735546:  // FUSE, of which nobody knows
      return true;
    default:
      return false;
  }
}

// Readers see whole episodes while the trainer writes, and a kill costs none that was committed. A
// write-ahead log needs memory that all who have the file open share, which two machines do not.
void PrepareForWriting(SqliteDatabase& database) {
  database.Execute(
      IsShared(database.file()) ? "PRAGMA journal_mode=DELETE" : "PRAGMA journal_mode=WAL",
      kOpening);
  database.Execute("PRAGMA synchronous=NORMAL; PRAGMA foreign_keys=ON", kOpening);
}

}  // namespace

RunDatabase::RunDatabase(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
RunDatabase::RunDatabase(RunDatabase&&) noexcept = default;
RunDatabase& RunDatabase::operator=(RunDatabase&&) noexcept = default;
RunDatabase::~RunDatabase() = default;

bool RunDatabase::Exists(const std::filesystem::path& folder) {
  std::error_code error;
  const auto size = std::filesystem::file_size(RunDatabaseFile(folder), error);
  return !error && size > 0;  // empty: its trainer was killed before the run was made
}

bool RunDatabase::IsUnfinished(const std::filesystem::path& folder) {
  if (Exists(folder)) return false;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(RunDatabaseFile("").string()) || IsKeptPlugin(name)) return true;
  }
  return false;
}

void RunDatabase::CheckIsFree(const std::filesystem::path& folder) {
  if (!Exists(folder)) return;
  throw UserError(
      fmt::format("{}: this folder holds a run already; continue it with `trainer resume {}`, or "
                  "name another folder with --out",
                  folder.string(), folder.string()));
}

RunDatabase RunDatabase::Create(const std::filesystem::path& folder, const RunRecord& run) {
  MakeRunFolder(folder);
  auto impl = std::make_unique<Impl>();
  impl->folder = folder;
  impl->lock = TakeLock(folder);
  CheckIsFree(folder);
  Impl::Make(folder, run);
  impl->OpenToWrite();
  return RunDatabase(std::move(impl));
}

void RunDatabase::Impl::Make(const std::filesystem::path& folder, const RunRecord& run) {
  const std::filesystem::path file = RunDatabaseFile(folder);
  std::filesystem::path part = file;
  part += ".part";
  // A journal that is left from an attempt before would be taken for one of the new file.
  for (const std::filesystem::path& each : {file, part}) {
    for (const char* suffix : {"", "-journal", "-wal", "-shm"}) {
      std::filesystem::path left = each;
      std::error_code ignored;
      std::filesystem::remove(left += suffix, ignored);
    }
  }
  {
    Impl made;
    made.database = std::make_unique<SqliteDatabase>(part, SqliteAccess::kCreate);
    SqliteTransaction transaction(*made.database, kMaking);
    made.database->Execute(fmt::format("PRAGMA application_id={}; PRAGMA user_version={};\n{}",
                                       kApplicationId, kSchemaVersion, kRunSchema),
                           kMaking);
    made.write.emplace(*made.database);
    made.WriteRun(run);
    transaction.Commit();
  }
  const std::error_code error = MoveFile(part, file);
  if (!error) return;
  throw RecordError(fmt::format("{}: cannot {}: {}; check the disk and the folder's permissions",
                                file.string(), kMaking, error.message()));
}

void RunDatabase::Impl::OpenToWrite() {
  database = OpenChecked(folder, SqliteAccess::kWrite);
  PrepareForWriting(*database);
  database->Execute(kRunSchema, kOpening);  // tables that an older version has not made
  write.emplace(*database);
}

RunDatabase RunDatabase::Open(const std::filesystem::path& folder) {
  auto impl = std::make_unique<Impl>();
  impl->folder = folder;
  if (Exists(folder)) impl->lock = TakeLock(folder);
  impl->OpenToWrite();
  return RunDatabase(std::move(impl));
}

RunDatabase RunDatabase::OpenToRead(const std::filesystem::path& folder) {
  auto impl = std::make_unique<Impl>();
  impl->folder = folder;
  impl->database = OpenChecked(folder, SqliteAccess::kRead);
  return RunDatabase(std::move(impl));
}

void RunDatabase::Impl::WriteCheckpoint(const Checkpoint& checkpoint) {
  const std::string sealed = SealState(checkpoint.episode, checkpoint.state);
  write->checkpoint.Bind(checkpoint.episode, Bytes(sealed)).Run();
}

void RunDatabase::Impl::WriteRun(const RunRecord& run) {
  for (const TextKey& text : kTexts) Set(text.key, run.*text.member);
  Set("seed", fmt::format("{}", run.seed));
  Set("episodes_planned", fmt::format("{}", run.episodes_planned));
  Set("record_every", fmt::format("{}", run.record_every));
  Set("checkpoint_seconds", fmt::format("{}", run.checkpoint_seconds));
  Set("started_at", IsoTimeNow());
  Set("state", std::string(RunStateName(RunState::kRunning)));
  for (const TaskRecord& task : run.tasks) WriteTask(task);
}

int64_t RunDatabase::Impl::WriteTask(const TaskRecord& task) {
  SqliteStatement row(*database, "INSERT INTO task VALUES (NULL, ?, ?, ?, ?, ?, ?)", "note a task");
  row.Bind(std::string_view(task.module), std::string_view(task.task),
           std::string_view(task.task_file), std::string_view(task.task_hash),
           std::string_view(task.plugin), std::string_view(task.compiler))
      .Run();
  const int64_t id = sqlite3_last_insert_rowid(database->handle());
  SqliteStatement term(*database, "INSERT INTO term VALUES (?, ?, ?, ?)", "note a task");
  for (size_t i = 0; i < task.terms.size(); ++i) {
    term.Bind(id, static_cast<int64_t>(i), std::string_view(task.terms[i].name),
              std::string_view(task.terms[i].doc))
        .Run();
  }
  SqliteStatement source(*database, "INSERT INTO source VALUES (?, ?, ?, ?)", "note a task");
  for (size_t i = 0; i < task.sources.size(); ++i) {
    source
        .Bind(id, static_cast<int64_t>(i), std::string_view(task.sources[i].file),
              std::string_view(task.sources[i].text))
        .Run();
  }
  SqliteStatement goal(*database, "INSERT INTO goal VALUES (?, ?, ?, ?, ?, ?)", "note a task");
  for (size_t i = 0; i < task.goals.size(); ++i) {
    const GoalRecord& each = task.goals[i];
    goal.Bind(id, static_cast<int64_t>(i), std::string_view(each.name), std::string_view(each.type),
              std::string_view(each.unit), std::string_view(each.doc))
        .Run();
  }
  SqliteStatement phase(*database, "INSERT INTO phase VALUES (?, ?, ?, ?)", "note a task");
  for (size_t i = 0; i < task.phases.size(); ++i) {
    phase
        .Bind(id, static_cast<int64_t>(i), std::string_view(task.phases[i].name),
              std::string_view(task.phases[i].doc))
        .Run();
  }
  WriteCurves("INSERT INTO metric VALUES (?, ?, ?, ?, ?, ?)", id, task.metrics);
  WriteCurves("INSERT INTO log VALUES (?, ?, ?, ?, ?, ?)", id, task.logs);
  return id;
}

void RunDatabase::Impl::WriteCurves(const char* insert, int64_t task,
                                    const std::vector<CurveRecord>& curves) {
  SqliteStatement row(*database, insert, "note a task");
  for (size_t i = 0; i < curves.size(); ++i) {
    const CurveRecord& curve = curves[i];
    row.Bind(task, static_cast<int64_t>(i), std::string_view(curve.name),
             std::string_view(curve.unit), std::string_view(curve.reduction),
             std::string_view(curve.doc))
        .Run();
  }
}

void RunDatabase::Impl::WriteEvaluation(int64_t episode, const Evaluation& evaluation,
                                        bool is_active) {
  write->evaluation
      .Bind(episode, evaluation.task, is_active ? 1 : 0, evaluation.episode_return,
            std::string_view(evaluation.end_kind), std::string_view(evaluation.end_reason),
            evaluation.faults, evaluation.violations)
      .Run();
  const auto add = [&](SqliteStatement& row, const std::vector<double>& values) {
    for (size_t i = 0; i < values.size(); ++i) {
      row.Bind(episode, evaluation.task, static_cast<int64_t>(i), values[i]).Run();
    }
  };
  add(write->term, evaluation.terms);
  add(write->metric, evaluation.metrics);
  add(write->log, evaluation.logs);
  for (size_t i = 0; i < evaluation.goals.size(); ++i) {
    const GoalDraw& draw = evaluation.goals[i];
    const std::string value = NumbersJson(draw.value);
    write->goal
        .Bind(episode, evaluation.task, static_cast<int64_t>(i), static_cast<int64_t>(draw.goal),
              draw.time, std::string_view(value))
        .Run();
  }
  for (size_t i = 0; i < evaluation.phases.size(); ++i) {
    const PhaseSums& sums = evaluation.phases[i];
    write->phase.Bind(episode, evaluation.task, static_cast<int64_t>(i), sums.time, sums.reward)
        .Run();
  }
}

void RunDatabase::AddEpisode(const EpisodeRecord& episode,
                             const std::optional<Recording>& recording,
                             const std::optional<Checkpoint>& checkpoint, const std::string& tape) {
  WriteStatements& write = *impl_->write;
  SqliteTransaction transaction(*impl_->database, fmt::format("save episode {}", episode.number));
  write.episode
      .Bind(episode.number, episode.steps, episode.actions, episode.simulated_seconds,
            episode.wall_seconds, episode.cpu_seconds)
      .Run();
  impl_->WriteEvaluation(episode.number, episode.active, true);
  for (const Evaluation& shadow : episode.shadows) {
    impl_->WriteEvaluation(episode.number, shadow, false);
  }
  for (const NamedValue& each : episode.learner) {
    write.learner.Bind(episode.number, each.value, std::string_view(each.name)).Run();
  }
  if (recording) {
    write.recording
        .Bind(episode.number, recording->is_best ? 1 : 0, recording->frames,
              recording->frame_interval, Bytes(recording->poses))
        .Run();
    if (!recording->timeline.empty()) {
      write.timeline.Bind(episode.number, Bytes(recording->timeline)).Run();
    }
    if (!tape.empty()) write.tape.Bind(episode.number, Bytes(tape)).Run();
  }
  if (checkpoint) impl_->WriteCheckpoint(*checkpoint);
  transaction.Commit();
}

void RunDatabase::WriteCheckpoint(const Checkpoint& checkpoint) {
  impl_->WriteCheckpoint(checkpoint);
}

int64_t RunDatabase::AddTask(const TaskRecord& task) {
  SqliteTransaction transaction(*impl_->database, "note a task");
  const int64_t id = impl_->WriteTask(task);
  transaction.Commit();
  return id;
}

int64_t RunDatabase::AddChange(const ChangeRecord& change) {
  SqliteStatement row(*impl_->database, "INSERT INTO change VALUES (NULL, ?, ?, ?, ?, ?, ?)",
                      "note a change");
  const std::string at = change.at.empty() ? IsoTimeNow() : change.at;
  const std::string data = ChangeData(change.change);
  row.Bind(change.episode, change.step, std::string_view(at), KindOf(change.change),
           std::string_view(change.text), std::string_view(data))
      .Run();
  return sqlite3_last_insert_rowid(impl_->database->handle());
}

void RunDatabase::SetLearnerCurves(const std::vector<CurveRecord>& curves) {
  SqliteTransaction transaction(*impl_->database, "note the learner's curves");
  SqliteStatement row(*impl_->database,
                      "INSERT INTO learner_curve (name, unit, doc) VALUES (?, ?, ?) "
                      "ON CONFLICT (name) DO UPDATE SET unit = excluded.unit, doc = excluded.doc",
                      "note the learner's curves");
  for (const CurveRecord& curve : curves) {
    row.Bind(std::string_view(curve.name), std::string_view(curve.unit),
             std::string_view(curve.doc))
        .Run();
  }
  transaction.Commit();
}

int64_t RunDatabase::MoveChange(int64_t id, int64_t episode, int64_t step) {
  SqliteStatement row(*impl_->database,
                      "UPDATE change SET id = (SELECT max(id) FROM change) + 1, episode = ?, "
                      "step = ? WHERE id = ? RETURNING id",
                      "note where a change took effect");
  row.Bind(episode, step, id);
  const int64_t moved = row.Step() ? row.Integer(0) : id;
  row.Run();
  return moved;
}

void RunDatabase::RemoveChange(int64_t id) {
  SqliteStatement(*impl_->database, "DELETE FROM change WHERE id = ?", "undo a change")
      .Bind(id)
      .Run();
}

void RunDatabase::DeleteEpisodesAfter(int64_t episode) {
  SqliteStatement(*impl_->database, "DELETE FROM episode WHERE number > ?",
                  "delete the episodes after the checkpoint")
      .Bind(episode)
      .Run();
}

void RunDatabase::SetState(RunState state) {
  SqliteTransaction transaction(*impl_->database, "save the run's state");
  impl_->Set("state", std::string(RunStateName(state)));
  if (state == RunState::kRunning) {
    impl_->database->Execute("DELETE FROM run WHERE key = 'finished_at'", "save the run's state");
  } else {
    impl_->Set("finished_at", IsoTimeNow());
  }
  transaction.Commit();
}

void RunDatabase::SetEpisodesPlanned(int64_t episodes) {
  impl_->Set("episodes_planned", fmt::format("{}", episodes));
}

}  // namespace runtime
