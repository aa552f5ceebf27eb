#include "tests/runtime/training/run/damages.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <memory>
#include <stdexcept>

namespace runtime {
namespace {

struct Close {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
};
using Database = std::unique_ptr<sqlite3, Close>;

Database Open(const std::filesystem::path& file) {
  sqlite3* database = nullptr;
  sqlite3_open(file.c_str(), &database);
  return Database(database);
}

std::vector<std::string> FirstColumn(sqlite3* database, const std::string& sql) {
  std::vector<std::string> values;
  const auto add = [](void* list, int, char** row, char**) {
    static_cast<std::vector<std::string>*>(list)->push_back(row[0]);
    return 0;
  };
  if (sqlite3_exec(database, sql.c_str(), add, &values, nullptr) != SQLITE_OK) {
    throw std::runtime_error(sqlite3_errmsg(database));
  }
  return values;
}

// `{0}` stands for the value that is there.
constexpr const char* kWrongValues[] = {
    "NULL", "-1", "0", "2", "0.5", "9223372036854775807", "1e300", "-9e999", "''", "'damaged'",
    "x''", "x'ff00'", "CAST({0} AS TEXT) || x'80'", "substr({0}, 1, length({0}) / 2)",
    "CAST(substr({0}, 1, length({0}) / 2) AS BLOB)", "CAST({0} || {0} AS BLOB)",
    // Of a text that holds JSON.
    "'[]'", "'{{}}'", "'[1, \"a\"]'", "'{{\"command\": 1}}'", "'{{\"command\": \"set\"}}'",
    "'{{\"command\": \"swap\", \"name\": \"task\", \"task\": 99}}'",
    "'[{{\"name\": \"a\", \"shape\": \"sphere\", \"size\": [1, 1, 1], \"radius\": 1e300, "
    "\"length\": 1, \"axis\": 7}}]'"};

void AddDamagesOfColumn(const std::string& table, const std::string& column, const std::string& key,
                        std::vector<Damage>& damages) {
  const std::string last = fmt::format("WHERE {0} = (SELECT max({0}) FROM {1})", key, table);
  for (const char* value : kWrongValues) {
    damages.push_back(fmt::format("UPDATE OR IGNORE {} SET {} = {} {}", table, column,
                                  fmt::format(fmt::runtime(value), column), last));
  }
  damages.push_back(fmt::format("ALTER TABLE {} RENAME COLUMN {} TO gone", table, column));
}

// What the table `run` says under each key.
void AddDamagesOfRun(sqlite3* database, std::vector<Damage>& damages) {
  for (const std::string& key : FirstColumn(database, "SELECT key FROM run")) {
    damages.push_back(fmt::format("DELETE FROM run WHERE key = '{}'", key));
    for (const char* value : kWrongValues) {
      damages.push_back(fmt::format("UPDATE run SET value = {} WHERE key = '{}'",
                                    fmt::format(fmt::runtime(value), "value"), key));
    }
  }
}

}  // namespace

void LiftConstraints(const std::filesystem::path& file) {
  const Database database = Open(file);
  FirstColumn(database.get(),
              "PRAGMA writable_schema = ON;"
              "UPDATE sqlite_master SET sql = "
              "replace(replace(sql, ' NOT NULL', ''), ' CHECK (id = 1)', '');"
              "PRAGMA writable_schema = RESET");
}

std::vector<Damage> AllDamages(const std::filesystem::path& file) {
  const Database database = Open(file);
  std::vector<Damage> damages;
  for (const std::string& table :
       FirstColumn(database.get(), "SELECT name FROM sqlite_master WHERE type = 'table'")) {
    const std::vector<std::string> columns =
        FirstColumn(database.get(), fmt::format("SELECT name FROM pragma_table_info('{}')", table));
    for (const std::string& column : columns) {
      if (table != "run") AddDamagesOfColumn(table, column, columns.front(), damages);
    }
    damages.push_back(fmt::format("DELETE FROM {}", table));
    damages.push_back(fmt::format("DROP TABLE {}", table));
    for (const char* which : {"min", "max"}) {
      damages.push_back(fmt::format("DELETE FROM {0} WHERE {1} = (SELECT {2}({1}) FROM {0})", table,
                                    columns.front(), which));
    }
  }
  AddDamagesOfRun(database.get(), damages);
  return damages;
}

bool Apply(const Damage& damage, const std::filesystem::path& file) {
  const Database database = Open(file);
  const int before = sqlite3_total_changes(database.get());
  if (sqlite3_exec(database.get(), damage.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
    return false;
  }
  const bool changes_rows = damage.starts_with("UPDATE") || damage.starts_with("DELETE");
  return !changes_rows || sqlite3_total_changes(database.get()) > before;
}

}  // namespace runtime
