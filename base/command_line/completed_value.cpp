#include "base/command_line/completed_value.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

namespace command_line {
namespace {

constexpr std::array<std::string_view, 2> kFolders = {"DIR", "RUN"};
constexpr std::array<std::string_view, 2> kFiles = {"FILE", "PATH"};

bool IsCapital(char c) { return c >= 'A' && c <= 'Z'; }

void AddFiles(const std::string& suffix, CompletedValue& value) {
  value.has_files = value.has_folders = true;
  if (!suffix.empty()) value.suffixes.push_back(suffix);
}

void AddPart(const std::string& part, const ValueLists& lists, CompletedValue& value) {
  const size_t dot = part.find('.');
  if (lists.names.contains(part)) value.names = part;
  if (const auto known = lists.words.find(part); known != lists.words.end()) {
    value.words = known->second;
  } else if (std::ranges::count(kFolders, part) > 0) {
    value.has_folders = true;
  } else if (part == "TASK") {
    AddFiles(".task", value);
  } else if (std::ranges::count(kFiles, part) > 0) {
    AddFiles("", value);
  } else if (dot != std::string::npos && dot > 0 &&
             std::ranges::all_of(part.substr(0, dot), IsCapital)) {
    AddFiles(part.substr(dot), value);
  } else if (std::ranges::none_of(part, IsCapital)) {
    value.words.push_back(part);
  }
}

}  // namespace

CompletedValue ValueCalled(const std::string& name, const ValueLists& lists) {
  CompletedValue value;
  std::istringstream stream(name);
  for (std::string part; std::getline(stream, part, '|');) AddPart(part, lists, value);
  return value;
}

std::string ValueOf(const std::string& option, const std::vector<std::string>& line) {
  std::string value;
  for (size_t i = 0; i < line.size(); ++i) {
    if (line[i] == option && i + 1 < line.size()) value = line[i + 1];
    if (line[i] == option && value == "=" && i + 2 < line.size()) value = line[i + 2];
    if (line[i].starts_with(option + "=")) value = line[i].substr(option.size() + 1);
  }
  return value;
}

}  // namespace command_line
