// What differs in meaning between two tasks.
#pragma once

#include <string>
#include <vector>

#include "compiler/difference/task_outline.h"

namespace compiler {

struct TaskChange {
  enum Kind {
    kAdded,    // only the second task has the part
    kRemoved,  // only the first one
    kRenamed,  // the same under another name: `after`
    kChanged   // the fact `what` of it was `before` and is `after`
  };
  Kind kind = kChanged;
  std::string part;  // "param", "term"
  std::string name;  // in the first task; of what was added in the second
  std::string what{};
  std::string before{};  // empty: there was none; may be several lines
  std::string after{};
};

// In the order of the parts; none where the tasks mean the same.
std::vector<TaskChange> Compare(const TaskOutline& first, const TaskOutline& second);

// "param fall_penalty: default: 2 -> 3", one line or more for each.
std::string ToText(const std::vector<TaskChange>& changes);

}  // namespace compiler
