// The names that a task declares: params, consts, sets, tables, memory, functions, the local values
// of its events and functions, and the variables of its loops.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

enum class SymbolKind {
  kParam,
  kConst,
  kSet,
  kTable,
  kMemory,
  kGoal,
  kPhase,      // the present one, `phase`
  kPhaseTime,  // `phase_time`
  kLocal,
  kLoopPart,    // of a loop over links, joints or sites: one of them
  kLoopNumber,  // of a loop over numbers: an `int` constant
  kFunction,
  kArgument  // of the function in which it is known
};

struct Symbol {
  SymbolKind kind = SymbolKind::kParam;
  Span span{};           // of the name where it is declared
  bool is_valid = true;  // false: its declaration is wrong, what depends on it is not reported
  // Among the task's params, consts, sets, tables, memory (of a goal: its value; of phases) or
  // functions, the event's or function's locals, or the function's arguments; or the value of a
  // loop's variable.
  uint32_t index = 0;
  Type type{};  // of a kLoopPart only `index` counts: "link"
  Unit unit{};
  std::optional<double> constant{};  // of a kLocal whose value is known
};

inline bool IsLoopVariable(const Symbol& symbol) {
  return symbol.kind == SymbolKind::kLoopPart || symbol.kind == SymbolKind::kLoopNumber;
}

inline bool IsNamedConstant(const Symbol& symbol) {
  return symbol.kind == SymbolKind::kConst || symbol.kind == SymbolKind::kSet ||
         symbol.kind == SymbolKind::kTable;
}

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
