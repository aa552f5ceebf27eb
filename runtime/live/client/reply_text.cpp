#include "runtime/live/client/reply_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace runtime {
namespace {

using nlohmann::json;

// Members in the order in which people want them; all others follow in alphabetical order.
constexpr std::string_view kOrder[] = {
    "number",      "run",         "robot",       "module",  "name",          "type",
    "task",        "role",        "state",       "value",   "takes_effect",  "from",
    "to",          "unit",        "minimum",     "maximum", "first_episode", "episode",
    "episodes",    "step",        "time",        "speed",   "episodes_done", "episodes_planned",
    "last_return", "mean_return", "best_return", "return",  "terms",         "hash",
    "previous",    "doc",         "file"};

constexpr size_t kHashDigits = 8;  // enough for people to tell versions apart
constexpr size_t kGap = 2;         // between two columns

bool IsTable(const json& value) {
  return value.is_array() && !value.empty() &&
         std::ranges::all_of(value, [](const json& row) { return row.is_object(); });
}

bool IsFlat(const json& value) {
  return value.is_object() && std::ranges::none_of(value, &json::is_structured);
}

bool HasLines(const json& value) {
  return value.is_string() && value.get_ref<const std::string&>().find('\n') != std::string::npos;
}

// Whether the value is shown below the others, under its name.
bool IsSection(const json& value) {
  return (value.is_object() && !IsFlat(value)) || IsTable(value) || HasLines(value);
}

std::vector<std::string> Ordered(std::vector<std::string> names) {
  std::ranges::stable_sort(names, {}, [](const std::string& name) {
    return std::ranges::find(kOrder, name) - std::begin(kOrder);
  });
  return names;
}

std::string CellText(std::string_view name, const json& value);

std::string ListText(std::string_view name, const json& list) {
  std::string text;
  for (const json& value : list) text += (text.empty() ? "" : ", ") + CellText(name, value);
  return text;
}

// "forward 12.5, effort -0.3"
std::string MembersText(const json& object) {
  std::vector<std::string> names;
  for (const auto& [name, value] : object.items()) names.push_back(name);
  std::string text;
  for (const std::string& name : Ordered(std::move(names))) {
    text += (text.empty() ? "" : ", ") + name + " " + CellText(name, object[name]);
  }
  return text;
}

std::string CellText(std::string_view name, const json& value) {
  if (value.is_null() || (value.is_structured() && value.empty())) return "-";
  if (value.is_object()) return MembersText(value);
  if (value.is_array()) return ListText(name, value);
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
  if (!value.is_string()) return value.dump();
  const std::string text = value;
  return name == "hash" ? text.substr(0, kHashDigits) : text;
}

// Characters, not bytes.
size_t Width(std::string_view text) {
  return static_cast<size_t>(
      std::ranges::count_if(text, [](char byte) { return (byte & 0xC0) != 0x80; }));
}

using Row = std::vector<std::string>;

std::string Aligned(const std::vector<Row>& rows) {
  std::vector<size_t> widths;
  for (const Row& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], Width(row[i]));
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (size_t i = 0; i < row.size(); ++i) {
      line += row[i] + std::string(widths[i] - Width(row[i]) + kGap, ' ');
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

// The members of all rows that fit into a cell.
std::vector<std::string> Columns(const json& table) {
  std::vector<std::string> names;
  for (const json& row : table) {
    for (const auto& [name, value] : row.items()) {
      if (!IsSection(value) && std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
  }
  return Ordered(std::move(names));
}

std::string Section(const std::string& title, const json& value);

// Titles are those of the rows: "task params".
std::string SectionsOf(const json& object, const std::string& title) {
  std::string text;
  for (const auto& [name, value] : object.items()) {
    if (IsSection(value)) text += Section(title + name, value);
  }
  return text;
}

std::string TableText(const json& table) {
  const std::vector<std::string> columns = Columns(table);
  std::vector<Row> rows = {columns};
  std::string sections;
  for (const json& object : table) {
    Row& row = rows.emplace_back();
    for (const std::string& name : columns) {
      row.push_back(CellText(name, object.value(name, json())));
    }
    sections += SectionsOf(object, row.front() + " ");
  }
  return Aligned(rows) + sections;
}

std::string ObjectText(const json& object) {
  std::vector<std::string> names;
  for (const auto& [name, value] : object.items()) {
    if (!IsSection(value)) names.push_back(name);
  }
  std::vector<Row> rows;
  for (const std::string& name : Ordered(std::move(names))) {
    rows.push_back({name, CellText(name, object[name])});
  }
  return Aligned(rows) + SectionsOf(object, "");
}

std::string Section(const std::string& title, const json& value) {
  return fmt::format("\n{}:\n{}", title, ReplyText(value));
}

// As a cell of a table; numbers that are none come as null.
std::string Member(const json& object, const char* name) {
  return CellText(name, object.value(name, json()));
}

std::string EpisodeLine(const json& event) {
  std::string line = fmt::format("episode {}: {} returns {}", Member(event, "episode"),
                                 Member(event, "task"), Member(event, "return"));
  const json end = event.value("end", json::object());
  if (!end.empty()) line += fmt::format(" ({}: {})", Member(end, "kind"), Member(end, "reason"));
  const json shadows = event.value("shadows", json::object());
  for (const auto& [name, shadow] : shadows.items()) {
    line += fmt::format(", {} {}", name, Member(shadow, "return"));
  }
  return line;
}

}  // namespace

std::string ReplyText(const json& value) {
  if (value.is_null()) return "";
  if (IsTable(value)) return TableText(value);
  if (value.is_object()) {
    const bool is_only_text = value.size() == 1 && value.contains("text");
    return is_only_text ? ReplyText(value["text"]) : ObjectText(value);
  }
  const std::string text = CellText("", value);
  return text.ends_with('\n') ? text : text + "\n";
}

std::string EventLine(const json& event) {
  const std::string kind = event.value("event", "");
  if (kind == "episode") return EpisodeLine(event);
  if (kind == "change") {
    return fmt::format("change {} in episode {}, step {}: {}", Member(event, "id"),
                       Member(event, "episode"), Member(event, "step"), Member(event, "text"));
  }
  if (kind == "state") return "the run is " + Member(event, "state");
  if (kind == "warning") return "warning: " + Member(event, "text");
  if (kind == "missed") return Member(event, "count") + " events were missed";
  return event.dump();
}

}  // namespace runtime
