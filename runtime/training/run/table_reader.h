// Reads a table of a run's database without trusting it: every value is checked for its type and
// its range, so that no later code meets what no trainer has written.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "runtime/training/run/sqlite.h"

namespace runtime {

class TableReader {
 public:
  // No count of anything is larger; up to here every whole number is a double, too.
  static constexpr int64_t kMost = int64_t{1} << 53;
  // No time is longer [s].
  static constexpr double kLongest = 1e12;

  // The rows of "SELECT `columns` FROM `table` `rest`". Refers to the database, which must outlive
  // it. All functions throw UserError, which names the file, the table, the row and the column.
  TableReader(const SqliteDatabase& database, std::string_view table, std::string_view columns,
              std::string_view rest);

  template <class... Values>
  TableReader& Bind(const Values&... values) {
    statement_.Bind(values...);
    return *this;
  }

  // Goes to the next row; false where there is none.
  bool Next();

  // Of the present row. Columns count from 0.
  int64_t Whole(int column, int64_t least, int64_t most = kMost);
  bool Flag(int column) { return Whole(column, 0, 1) != 0; }
  double Real(int column);                      // not a number where it is NULL
  double Time(int column, double least = 0.0);  // [s], finite
  std::string Text(int column);
  std::string Name(int column);  // a text that is not empty
  std::string Blob(int column);

  // Throws with what is wrong about a column ("is not a number"), or about the whole table
  // ("is empty").
  [[noreturn]] void FailAt(int column, std::string_view what) const;
  [[noreturn]] void Fail(std::string_view what) const;

 private:
  void Require(bool is_sound, int column, std::string_view what) const {
    if (!is_sound) FailAt(column, what);
  }

  const SqliteDatabase& database_;
  std::string table_;
  SqliteStatement statement_;
  int64_t row_ = 0;  // from 1, in the order of reading
};

// Whether the database has this table: an older version may have written it without.
bool HasTable(const SqliteDatabase& database, std::string_view table);

// Throws the UserError for a run whose database holds `what` ("the table `run` is empty").
[[noreturn]] void ThrowDamaged(const SqliteDatabase& database, std::string_view what);

}  // namespace runtime
