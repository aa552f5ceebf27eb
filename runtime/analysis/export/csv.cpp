#include "runtime/analysis/export/csv.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace runtime {
namespace {

std::string Quoted(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

// In the order in which they appear.
std::vector<std::string> NamesOf(const std::vector<TableOfRun>& runs) {
  std::vector<std::string> names;
  for (const TableOfRun& run : runs) {
    for (const EpisodeColumn& column : run.table.columns)
      if (std::ranges::find(names, column.name) == names.end()) names.push_back(column.name);
  }
  return names;
}

// One for each of `names`; null where the table has none.
std::vector<const EpisodeColumn*> ColumnsOf(const EpisodeTable& table,
                                            const std::vector<std::string>& names) {
  std::vector<const EpisodeColumn*> columns;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(table.columns, name, &EpisodeColumn::name);
    columns.push_back(found == table.columns.end() ? nullptr : &*found);
  }
  return columns;
}

void AppendTable(const EpisodeTable& table, const std::vector<std::string>& names,
                 const std::string& run_field, std::string& csv) {
  const std::vector<const EpisodeColumn*> columns = ColumnsOf(table, names);
  for (size_t i = 0; i < table.episodes.size(); ++i) {
    const EpisodeRecord& episode = table.episodes[i];
    csv += fmt::format("{}{},{},{}", run_field, episode.number, Quoted(episode.active.end_kind),
                       Quoted(episode.active.end_reason));
    for (const EpisodeColumn* column : columns) {
      csv += ',';
      if (column != nullptr && !std::isnan(column->values[i]))
        csv += fmt::to_string(column->values[i]);
    }
    csv += '\n';
  }
}

}  // namespace

std::string CsvOf(const std::vector<TableOfRun>& runs) {
  const bool has_many = runs.size() > 1;
  const std::vector<std::string> names = NamesOf(runs);
  std::string csv = has_many ? "run,episode,end,reason" : "episode,end,reason";
  for (const std::string& name : names) csv += ',' + Quoted(name);
  csv += '\n';
  for (const auto& [run, table] : runs)
    AppendTable(table, names, has_many ? Quoted(run) + ',' : "", csv);
  return csv;
}

std::string CsvOf(const std::vector<std::string>& columns,
                  const std::vector<std::vector<double>>& rows) {
  std::string csv;
  for (const std::string& column : columns) csv += (csv.empty() ? "" : ",") + Quoted(column);
  for (const std::vector<double>& row : rows) csv += fmt::format("\n{}", fmt::join(row, ","));
  return csv + '\n';
}

}  // namespace runtime
