// SQLite with owners for its handles and RecordErrors for its result codes.
#pragma once

#include <sqlite3.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace runtime {

enum class SqliteAccess { kRead, kWrite, kCreate };

class SqliteDatabase {
 public:
  // Throws RecordError where the file cannot be opened.
  SqliteDatabase(std::filesystem::path file, SqliteAccess access);

  const std::filesystem::path& file() const { return file_; }
  sqlite3* handle() const { return handle_.get(); }

  // Runs any number of statements that return nothing of interest. `purpose` completes the sentence
  // "cannot ..." of the error. Throws RecordError, as everything that runs SQL here.
  void Execute(const std::string& sql, std::string_view purpose);
  int64_t QueryInteger(const std::string& sql, std::string_view purpose);

  // Throws a RecordError that names the file, what failed, why and the remedy.
  [[noreturn]] void Fail(int code, std::string_view purpose) const;

 private:
  struct Close {
    void operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }
  };
  std::filesystem::path file_;
  std::unique_ptr<sqlite3, Close> handle_;
};

// A statement that is compiled once and run many times. Refers to the database, which must outlive
// it.
class SqliteStatement {
 public:
  SqliteStatement(const SqliteDatabase& database, std::string_view sql, std::string purpose);

  // Sets all values, in order, before the first Step. Texts and blobs must live until Run or Reset.
  template <class... Values>
  SqliteStatement& Bind(const Values&... values) {
    int index = 0;
    (BindOne(++index, values), ...);
    return *this;
  }

  bool Step();   // true: there is a row
  void Reset();  // ready for other values
  void Run();    // all of it, for statements without rows

  // Columns of the present row, from 0. SQLite gives any type as any other: see Type() first where
  // that matters. A real that is NULL is not a number. Text and blob are copies.
  int Type(int column) const { return sqlite3_column_type(handle_.get(), column); }
  const char* ColumnName(int column) const { return sqlite3_column_name(handle_.get(), column); }
  int64_t Integer(int column) const { return sqlite3_column_int64(handle_.get(), column); }
  double Real(int column) const;
  std::string Text(int column) const;
  std::string Blob(int column) const;

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* handle) const { sqlite3_finalize(handle); }
  };
  void BindOne(int index, int64_t value);
  void BindOne(int index, int value) { BindOne(index, static_cast<int64_t>(value)); }
  void BindOne(int index, double value);
  void BindOne(int index, std::string_view value);
  void BindOne(int index, std::span<const std::byte> value);
  void Check(int code) const;

  const SqliteDatabase* database_;
  std::string purpose_;
  std::unique_ptr<sqlite3_stmt, Finalize> handle_;
};

// All or nothing: rolls back unless it was committed.
class SqliteTransaction {
 public:
  SqliteTransaction(SqliteDatabase& database, std::string purpose);
  SqliteTransaction(const SqliteTransaction&) = delete;
  SqliteTransaction& operator=(const SqliteTransaction&) = delete;
  ~SqliteTransaction();
  void Commit();

 private:
  SqliteDatabase* database_;
  std::string purpose_;
  bool open_ = true;
};

}  // namespace runtime
