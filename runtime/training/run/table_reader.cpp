#include "runtime/training/run/table_reader.h"

#include <fmt/format.h>

#include <cmath>

#include "runtime/base/user_error.h"

namespace runtime {

TableReader::TableReader(const SqliteDatabase& database, std::string_view table,
                         std::string_view columns, std::string_view rest)
    : database_(database),
      table_(table),
      statement_(database, fmt::format("SELECT {} FROM {} {}", columns, table, rest),
                 fmt::format("read the table `{}`", table)) {}

bool TableReader::Next() {
  ++row_;
  return statement_.Step();
}

int64_t TableReader::Whole(int column, int64_t least, int64_t most) {
  Require(statement_.Type(column) == SQLITE_INTEGER, column, "is not an integer");
  const int64_t value = statement_.Integer(column);
  Require(least <= value && value <= most, column, fmt::format("cannot be {}", value));
  return value;
}

double TableReader::Real(int column) {
  const int type = statement_.Type(column);
  Require(type == SQLITE_FLOAT || type == SQLITE_INTEGER || type == SQLITE_NULL, column,
          "is not a number");
  return statement_.Real(column);
}

double TableReader::Time(int column, double least) {
  const double value = Real(column);
  Require(least <= value && value <= kLongest, column, fmt::format("cannot be {} s", value));
  return value;
}

std::string TableReader::Text(int column) {
  Require(statement_.Type(column) == SQLITE_TEXT, column, "is not a string");
  return statement_.Text(column);
}

std::string TableReader::Name(int column) {
  std::string name = Text(column);
  Require(!name.empty(), column, "is empty");
  return name;
}

std::string TableReader::Blob(int column) {
  Require(statement_.Type(column) == SQLITE_BLOB, column, "holds no data");
  return statement_.Blob(column);
}

void TableReader::FailAt(int column, std::string_view what) const {
  ThrowDamaged(database_, fmt::format("the table `{}`, row {}: `{}` {}", table_, row_,
                                      statement_.ColumnName(column), what));
}

void TableReader::Fail(std::string_view what) const {
  ThrowDamaged(database_, fmt::format("the table `{}` {}", table_, what));
}

bool HasTable(const SqliteDatabase& database, std::string_view table) {
  return SqliteStatement(database, "SELECT 1 FROM sqlite_master WHERE name = ?", "read the run")
      .Bind(table)
      .Step();
}

void ThrowDamaged(const SqliteDatabase& database, std::string_view what) {
  throw UserError(
      fmt::format("{}: the run is damaged: {}; restore a copy of the file, or start another run",
                  database.file().string(), what));
}

}  // namespace runtime
