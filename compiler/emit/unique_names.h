// C++ identifiers for the names of a task.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace compiler {

// Hands out the identifiers of one C++ scope: each is the wanted name where that is possible, and
// otherwise one that looks like it. Keywords and the names that the emitted text itself stands on
// are never handed out.
class UniqueNames {
 public:
  UniqueNames() = default;
  // A scope inside `outer`, whose names it does not hide. Refers to it, which must outlive it.
  explicit UniqueNames(const UniqueNames* outer) : outer_(outer) {}

  // `base.velocity` becomes `base_velocity`, `new` becomes `new_`, a second `x` becomes `x_2`.
  std::string Add(std::string_view wanted);
  // Never hands out this name.
  void Reserve(std::string_view name) { taken_.emplace(name); }

  // The names handed out from here on can be given back, where a block ends.
  size_t Mark() const { return added_.size(); }
  void GiveBackTo(size_t mark);

 private:
  // A name as handed out, and without the number.
  struct Added {
    std::string unique;
    std::string name;
  };

  bool IsTaken(const std::string& name) const;

  const UniqueNames* outer_ = nullptr;
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, int> next_;  // numbers below it are taken
  std::vector<Added> added_;
};

}  // namespace compiler
