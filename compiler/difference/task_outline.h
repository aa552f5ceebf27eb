// What a task means, in small parts that can be compared with those of another task.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compiler/analyze/analyze.h"

namespace compiler {

// One thing that is to be known of a part: "default" is "4 1/s".
struct Fact {
  std::string what;
  std::string text;

  bool operator==(const Fact&) const = default;
  auto operator<=>(const Fact&) const = default;
};

// A param, a term, an end and the like.
struct OutlinePart {
  std::string kind;  // "param"
  std::string name;  // "" where there is only one of the kind
  std::vector<Fact> facts;
};

struct TaskOutline {
  std::vector<OutlinePart> parts;
  // What each event does, statement by statement: all of it is among the facts, but not its order.
  std::map<std::string, std::vector<std::string>> orders;

  // A new one where there is none yet.
  OutlinePart& Part(const std::string& kind, const std::string& name);
};

// Without layout, comments, the names of local values, functions, consts and sets, and the task's
// own name. The analysis has a task.
TaskOutline OutlineOf(const Analysis& analysis);

}  // namespace compiler
