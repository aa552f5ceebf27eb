// What the parts of RunDatabase share; for them only.
#pragma once

#include <optional>
#include <string>

#include "runtime/run/folder_lock.h"
#include "runtime/run/run_database.h"
#include "runtime/run/sqlite.h"

namespace runtime {

// The texts of a run and their keys in the table `run`.
struct TextKey {
  const char* key;
  std::string RunRecord::*member;
};
inline constexpr TextKey kTexts[] = {
    {"task", &RunRecord::task},           {"task_file", &RunRecord::task_file},
    {"task_hash", &RunRecord::task_hash}, {"plugin", &RunRecord::plugin},
    {"robot", &RunRecord::robot},         {"robot_description", &RunRecord::robot_description},
    {"agent", &RunRecord::agent},         {"profile", &RunRecord::profile},
    {"version", &RunRecord::version},     {"compiler", &RunRecord::compiler},
    {"body", &RunRecord::body},
};

// The statements that run once per episode.
struct WriteStatements {
  explicit WriteStatements(const SqliteDatabase& database)
      : episode(database, "INSERT INTO episode VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
                "save an episode"),
        term(database, "INSERT INTO episode_term VALUES (?, ?, ?)", "save an episode"),
        metric(database, "INSERT INTO episode_metric VALUES (?, ?, ?)", "save an episode"),
        log(database, "INSERT INTO episode_log VALUES (?, ?, ?)", "save an episode"),
        recording(database, "INSERT INTO recording VALUES (?, ?, ?, ?, ?)", "save a recording"),
        checkpoint(database, "INSERT OR REPLACE INTO checkpoint VALUES (1, ?, ?)",
                   "save a checkpoint"),
        set_value(database, "INSERT OR REPLACE INTO run VALUES (?, ?)", "save the run's state") {}

  SqliteStatement episode;
  SqliteStatement term;
  SqliteStatement metric;
  SqliteStatement log;
  SqliteStatement recording;
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

  std::filesystem::path folder;
  std::optional<FolderLock> lock;  // of a writer
  std::unique_ptr<SqliteDatabase> database;
  std::optional<WriteStatements> write;

  void Set(const std::string& key, const std::string& value) {
    write->set_value.Bind(std::string_view(key), std::string_view(value)).Run();
  }
  void WriteRun(const RunRecord& run);
  void WriteCurves(const char* insert, const std::vector<CurveRecord>& curves);
  void WriteCheckpoint(const Checkpoint& checkpoint);
};

}  // namespace runtime
