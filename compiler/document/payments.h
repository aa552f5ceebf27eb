// What the statements of a block pay, gathered for each reward term.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/document/latex.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// "once per episode"
std::string OncePer(MemoryScope scope);

// The term that a statement pays; nothing for any other statement.
std::optional<std::string> PaidTerm(const Statement& statement);

// What a term is paid, under all its conditions, and the names that this reads.
struct Payment {
  Formula amount;
  std::vector<std::string> reads;
};
Payment PaymentOf(const std::string& term, const std::vector<const Block*>& blocks);

}  // namespace compiler
