#include "runtime/training/run/sqlite.h"

#include <fmt/format.h>

#include <cstring>
#include <limits>

#include "runtime/training/run/record_error.h"

namespace runtime {
namespace {

// How long another program may lock the file. Somebody who only looks need not wait for a backup to
// end; a training that did not would be over.
int Patience(SqliteAccess access) {  // [ms]
  return access == SqliteAccess::kRead ? 2'000 : 30'000;
}

int OpenFlags(SqliteAccess access) {
  switch (access) {
    case SqliteAccess::kRead:
      return SQLITE_OPEN_READONLY | SQLITE_OPEN_EXRESCODE;
    case SqliteAccess::kWrite:
      return SQLITE_OPEN_READWRITE | SQLITE_OPEN_EXRESCODE;
    case SqliteAccess::kCreate:
      break;
  }
  return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_EXRESCODE;
}

// What SQLite counts of its memory nobody asks for, and threads that read one run each wait for one
// another to count. Only before it is first used can it be told so.
void CountNoMemory() {
  [[maybe_unused]] static const int is_told = sqlite3_config(SQLITE_CONFIG_MEMSTATUS, 0);
}

// What went wrong and what to do, for a person.
std::string Explain(int code, int system_error) {
  switch (code & 0xff) {
    case SQLITE_FULL:
      return "the disk is full; free some space";
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_CANTOPEN:
      return "the file or its folder cannot be opened for that; check that both exist and that you "
             "may write them";
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "another program, such as a database browser or a backup, keeps the file locked; "
             "close "
             "that program";
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
    case SQLITE_ERROR:       // a table or a column is missing
    case SQLITE_CONSTRAINT:  // what is there cannot be, beside what is to be written
      return "the file is damaged or not a database; use a copy of it, or start another run";
    default:
      break;
  }
  std::string cause = sqlite3_errstr(code);
  if (system_error != 0) cause += fmt::format(" ({})", std::strerror(system_error));
  return cause + "; check the disk and its quota";
}

}  // namespace

SqliteDatabase::SqliteDatabase(std::filesystem::path file, SqliteAccess access)
    : file_(std::move(file)) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(file_, ignored);
  // SQLite would wait for the writer of a named pipe.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw UserError(
        fmt::format("{}: this is not a file; a run keeps its database there", file_.string()));
  }
  CountNoMemory();
  sqlite3* opened = nullptr;
  const int code = sqlite3_open_v2(file_.c_str(), &opened, OpenFlags(access), nullptr);
  handle_.reset(opened);
  if (code != SQLITE_OK) Fail(code, "open the run");
  sqlite3_busy_timeout(handle(), Patience(access));
}

void SqliteDatabase::Execute(const std::string& sql, std::string_view purpose) {
  const int code = sqlite3_exec(handle(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) Fail(code, purpose);
}

int64_t SqliteDatabase::QueryInteger(const std::string& sql, std::string_view purpose) {
  SqliteStatement query(*this, sql, std::string(purpose));
  return query.Step() ? query.Integer(0) : 0;
}

void SqliteDatabase::Fail(int code, std::string_view purpose) const {
  const int system_error = handle() == nullptr ? 0 : sqlite3_system_errno(handle());
  throw RecordError(
      fmt::format("{}: cannot {}: {}", file_.string(), purpose, Explain(code, system_error)));
}

SqliteStatement::SqliteStatement(const SqliteDatabase& database, std::string_view sql,
                                 std::string purpose)
    : database_(&database), purpose_(std::move(purpose)) {
  sqlite3_stmt* prepared = nullptr;
  const int code = sqlite3_prepare_v3(database.handle(), sql.data(), static_cast<int>(sql.size()),
                                      SQLITE_PREPARE_PERSISTENT, &prepared, nullptr);
  handle_.reset(prepared);
  Check(code);
}

bool SqliteStatement::Step() {
  const int code = sqlite3_step(handle_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  sqlite3_reset(handle_.get());
  database_->Fail(code, purpose_);
}

void SqliteStatement::Reset() {
  sqlite3_reset(handle_.get());
  sqlite3_clear_bindings(handle_.get());
}

void SqliteStatement::Run() {
  while (Step()) {
  }
  Reset();
}

double SqliteStatement::Real(int column) const {
  if (sqlite3_column_type(handle_.get(), column) == SQLITE_NULL) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return sqlite3_column_double(handle_.get(), column);
}

std::string SqliteStatement::Text(int column) const {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(handle_.get(), column));
  const int size = sqlite3_column_bytes(handle_.get(), column);
  return text == nullptr ? std::string() : std::string(text, static_cast<size_t>(size));
}

std::string SqliteStatement::Blob(int column) const {
  const auto* bytes = static_cast<const char*>(sqlite3_column_blob(handle_.get(), column));
  const int size = sqlite3_column_bytes(handle_.get(), column);
  return bytes == nullptr ? std::string() : std::string(bytes, static_cast<size_t>(size));
}

void SqliteStatement::BindOne(int index, int64_t value) {
  Check(sqlite3_bind_int64(handle_.get(), index, value));
}

void SqliteStatement::BindOne(int index, double value) {
  Check(sqlite3_bind_double(handle_.get(), index, value));
}

void SqliteStatement::BindOne(int index, std::string_view value) {
  const char* text = value.data() == nullptr ? "" : value.data();  // null would be bound as NULL
  Check(sqlite3_bind_text64(handle_.get(), index, text, value.size(), SQLITE_STATIC, SQLITE_UTF8));
}

void SqliteStatement::BindOne(int index, std::span<const std::byte> value) {
  Check(sqlite3_bind_blob64(handle_.get(), index, value.data(), value.size(), SQLITE_STATIC));
}

void SqliteStatement::Check(int code) const {
  if (code != SQLITE_OK) database_->Fail(code, purpose_);
}

SqliteTransaction::SqliteTransaction(SqliteDatabase& database, std::string purpose)
    : database_(&database), purpose_(std::move(purpose)) {
  database_->Execute("BEGIN IMMEDIATE", purpose_);
}

SqliteTransaction::~SqliteTransaction() {
  // SQLite may have rolled back by itself; then there is nothing left to do.
  if (open_) sqlite3_exec(database_->handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void SqliteTransaction::Commit() {
  database_->Execute("COMMIT", purpose_);
  open_ = false;
}

}  // namespace runtime
