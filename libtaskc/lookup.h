// Entries of a task's tables by their names.
#pragma once

#include <fmt/format.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/suggestion.h"
#include "libtaskc/failure.h"

namespace libtaskc {

template <class Entry>
std::vector<std::string> NamesOf(std::span<const Entry> entries) {
  std::vector<std::string> names;
  for (const Entry& entry : entries) names.emplace_back(entry.name);
  return names;
}

// The index of the entry called `name`. `what`: what such an entry is, for the message. Throws
// Failure.
template <class Entry>
size_t IndexOf(const taskc_plugin& task, std::span<const Entry> entries, const char* name,
               std::string_view what) {
  RequirePointer(name, "the name");
  for (size_t i = 0; i < entries.size(); ++i) {
    if (std::string_view(entries[i].name) == name) return i;
  }
  throw Failure(TASKC_ERROR_UNKNOWN_NAME,
                fmt::format("the task `{}` has no {} `{}`{}", task.name, what, name,
                            text::Suggestion(name, NamesOf(entries))));
}

// `unit`: what the host says; null: nothing. `name`: whose it is. Throws Failure.
inline void CheckUnit(const char* unit, std::string_view wanted, std::string_view name) {
  if (unit == nullptr || unit == wanted) return;
  const auto named = [](std::string_view text) {
    return text.empty() ? std::string("a plain number") : fmt::format("in `{}`", text);
  };
  throw Failure(TASKC_ERROR_WRONG_UNIT,
                fmt::format("`{}` is {}, not {}", name, named(wanted), named(unit)));
}

}  // namespace libtaskc
