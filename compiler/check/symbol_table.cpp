#include "compiler/check/symbol_table.h"

namespace compiler {

const Symbol* SymbolTable::Find(std::string_view name) const {
  const auto found = symbols_.find(name);
  return found == symbols_.end() ? nullptr : &found->second;
}

bool SymbolTable::Declare(const std::string& name, const Symbol& symbol) {
  const bool is_new = symbols_.try_emplace(name, symbol).second;
  if (is_new && !blocks_.empty()) blocks_.back().push_back(name);
  return is_new;
}

std::vector<std::string> SymbolTable::Names() const {
  std::vector<std::string> names;
  for (const auto& [name, symbol] : symbols_) names.push_back(name);
  return names;
}

void SymbolTable::OpenBlock() { blocks_.emplace_back(); }

void SymbolTable::CloseBlock() {
  for (const std::string& name : blocks_.back()) symbols_.erase(name);
  blocks_.pop_back();
}

}  // namespace compiler
