#include "runtime/training/run/change_data.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <vector>

namespace runtime {
namespace {

using Json = nlohmann::json;
using Keys = std::vector<const char*>;

// What a change of each kind must say.
const std::map<std::string, Keys> kNeeded = {
    {"swap", {"name", "task"}},
    {"load", {"name", "task"}},
    {"rollback", {"name", "task"}},
    {"promote", {"name"}},
    {"unload", {"name"}},
    {"set", {"name"}},
    {"connect", {"first", "second"}},
    {"disconnect", {"first", "second"}},
    {"module_add", {"type", "name"}},
    {"module_remove", {"name"}},
    {"quarantine", {"why"}},
};

constexpr int64_t kMost = int64_t{1} << 53;

bool IsWhole(const Json& value, int64_t most) {
  return value.is_number_integer() && value >= 1 && value <= most;
}

// Whether a key has a value of the type that all changes give it.
bool HasItsType(const std::string& key, const Json& value, int64_t task_count) {
  if (key == "task") return IsWhole(value, task_count);
  if (key == "change" || key == "episodes") return IsWhole(value, kMost);
  if (key == "from" || key == "to") return value.is_number();
  if (key == "forget") return value.is_boolean();
  if (key == "parameters") return value.is_object();
  for (const char* text : {"command", "name", "type", "first", "second", "why"}) {
    if (key == text) return value.is_string();
  }
  return true;
}

Keys Missing(const Json& change, const Keys& needed) {
  Keys missing;
  for (const char* key : needed) {
    if (!change.contains(key)) missing.push_back(key);
  }
  return missing;
}

// A value at once, or a schedule.
Keys MissingOfSet(const Json& change) {
  return change.contains("value") ? Keys() : Missing(change, {"from", "to", "episodes"});
}

}  // namespace

std::string WhatIsWrongWithChange(const std::string& kind, const std::string& data,
                                  int64_t task_count) {
  const Json change = Json::parse(data, nullptr, false);
  if (!change.is_object()) return "is no JSON object";
  for (const auto& [key, value] : change.items()) {
    if (!HasItsType(key, value, task_count)) return fmt::format("has a wrong `{}`", key);
  }
  if (change.value("command", std::string()) != kind) return "is of another kind";
  const auto needed = kNeeded.find(kind);
  if (needed == kNeeded.end()) return "";
  Keys missing = Missing(change, needed->second);
  if (missing.empty() && kind == "set") missing = MissingOfSet(change);
  return missing.empty() ? "" : fmt::format("has no `{}`", missing.front());
}

}  // namespace runtime
