// C++ identifiers for the names of a task.
#pragma once

#include <string>
#include <string_view>
#include <unordered_set>

namespace compiler {

// Hands out the identifiers of one C++ scope: each is the wanted name where that is possible, and
// otherwise one that looks like it. Keywords and the names that the emitted text itself stands on
// are never handed out. Copy it to open an inner scope whose names must not hide those of the
// outer.
class UniqueNames {
 public:
  // `base.velocity` becomes `base_velocity`, `new` becomes `new_`, a second `x` becomes `x_2`.
  std::string Add(std::string_view wanted);
  // Never hands out this name.
  void Reserve(std::string_view name) { taken_.emplace(name); }

 private:
  std::unordered_set<std::string> taken_;
};

}  // namespace compiler
