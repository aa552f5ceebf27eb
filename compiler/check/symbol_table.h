// The names that a task declares: params, memory, and the local values of its events.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

enum class SymbolKind { kParam, kMemory, kLocal };

struct Symbol {
  SymbolKind kind = SymbolKind::kParam;
  Span span{};           // of the name where it is declared
  bool is_valid = true;  // false: its declaration is wrong, what depends on it is not reported
  uint32_t index = 0;    // among the task's params or memory, or the event's locals
  Type type{};
  Unit unit{};
};

// Names are unique among all that are visible at a place: nothing is ever shadowed.
class SymbolTable {
 public:
  // The visible symbol called `name`, or null. Valid until the next change of the table.
  const Symbol* Find(std::string_view name) const;
  // False where the name is taken; the table is then as before.
  bool Declare(const std::string& name, const Symbol& symbol);
  std::vector<std::string> Names() const;

  // A block's symbols are forgotten at its end.
  void OpenBlock();
  void CloseBlock();

 private:
  std::map<std::string, Symbol, std::less<>> symbols_;
  std::vector<std::vector<std::string>> blocks_;
};

}  // namespace compiler
