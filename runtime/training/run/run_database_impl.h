// What the parts of RunDatabase share; for them only.
#pragma once

#include <optional>
#include <string>

#include "runtime/base/folder_lock.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/sqlite.h"

namespace runtime {

// The texts of a run and their keys in the table `run`.
struct TextKey {
  const char* key;
  std::string RunRecord::*member;
};
inline constexpr TextKey kTexts[] = {
    {"robot", &RunRecord::robot},       {"robot_description", &RunRecord::robot_description},
    {"agent", &RunRecord::agent},       {"profile", &RunRecord::profile},
    {"body", &RunRecord::body},         {"version", &RunRecord::version},
    {"settings", &RunRecord::settings}, {"call", &RunRecord::call},
};

// The statements that run once per episode.
struct WriteStatements {
  explicit WriteStatements(const SqliteDatabase& database)
      : episode(database, "INSERT INTO episode VALUES (?, ?, ?, ?, ?, ?)", "save an episode"),
        evaluation(database, "INSERT INTO evaluation VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
                   "save an episode"),
        term(database, "INSERT INTO evaluation_term VALUES (?, ?, ?, ?)", "save an episode"),
        metric(database, "INSERT INTO evaluation_metric VALUES (?, ?, ?, ?)", "save an episode"),
        log(database, "INSERT INTO evaluation_log VALUES (?, ?, ?, ?)", "save an episode"),
        goal(database, "INSERT INTO evaluation_goal VALUES (?, ?, ?, ?, ?, ?)", "save an episode"),
        phase(database, "INSERT INTO evaluation_phase VALUES (?, ?, ?, ?, ?)", "save an episode"),
        learner(database,
                "INSERT INTO learner_value SELECT ?, id, ? FROM learner_curve WHERE name = ?",
                "save an episode"),
        recording(database, "INSERT INTO recording VALUES (?, ?, ?, ?, ?)", "save a recording"),
        timeline(database, "INSERT INTO timeline VALUES (?, ?)", "save a recording"),
        tape(database, "INSERT INTO tape VALUES (?, ?)", "save a recording"),
        checkpoint(database, "INSERT OR REPLACE INTO checkpoint VALUES (1, ?, ?)",
                   "save a checkpoint"),
        set_value(database, "INSERT OR REPLACE INTO run VALUES (?, ?)", "save the run's state") {}

  SqliteStatement episode;
  SqliteStatement evaluation;
  SqliteStatement term;
  SqliteStatement metric;
  SqliteStatement log;
  SqliteStatement goal;
  SqliteStatement phase;
  SqliteStatement learner;
  SqliteStatement recording;
  SqliteStatement timeline;
  SqliteStatement tape;
  SqliteStatement checkpoint;
  SqliteStatement set_value;
};

struct RunDatabase::Impl {
  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  // Leaves one file that can be copied and read anywhere, unless someone reads it just now.
  ~Impl() {
    if (!write) return;
    write.reset();
    sqlite3_busy_timeout(database->handle(), 0);
    sqlite3_exec(database->handle(), "PRAGMA journal_mode=DELETE", nullptr, nullptr, nullptr);
  }

  // Under another name until all of it is there.
  static void Make(const std::filesystem::path& folder, const RunRecord& run);
  void OpenToWrite();

  std::filesystem::path folder;
  std::optional<FolderLock> lock;  // of a writer
  std::unique_ptr<SqliteDatabase> database;
  std::optional<WriteStatements> write;

  void Set(const std::string& key, const std::string& value) {
    write->set_value.Bind(std::string_view(key), std::string_view(value)).Run();
  }
  void WriteRun(const RunRecord& run);
  int64_t WriteTask(const TaskRecord& task);
  void WriteCurves(const char* insert, int64_t task, const std::vector<CurveRecord>& curves);
  void WriteEvaluation(int64_t episode, const Evaluation& evaluation, bool is_active);
  void WriteCheckpoint(const Checkpoint& checkpoint);
};

}  // namespace runtime
