// How the checks of tables write their messages.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/check/report.h"
#include "compiler/check/task_scope.h"

namespace compiler {

// Of one file or table no more is said: a wrong one may have hundreds of mistakes.
inline constexpr size_t kMostTableMessages = 5;

class TableMessages {
 public:
  explicit TableMessages(const TaskScope& scope) : scope_(scope) {}

  void Add(std::string_view code, Span span, std::string message, Explanation explanation) {
    if (++count_ <= kMostTableMessages)
      Report(scope_.diagnostics, code, span, std::move(message), std::move(explanation));
  }
  bool is_empty() const { return count_ == 0; }

 private:
  const TaskScope& scope_;
  size_t count_ = 0;
};

// The names, or of many the first.
inline std::string ListOfColumns(std::vector<std::string> names) {
  constexpr size_t kMost = 5;
  const size_t more = names.size() > kMost ? names.size() - kMost : 0;
  if (more == 0) return List(names);
  names.resize(kMost);
  std::string text;
  for (const std::string& name : names) text += fmt::format("`{}`, ", name);
  return fmt::format("{}and {} more", text, more);
}

}  // namespace compiler
