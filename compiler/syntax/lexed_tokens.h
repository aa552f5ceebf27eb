// The words and signs of any text, also of one that is not a task yet: for what must understand a
// text while it is being written.
#pragma once

#include <string_view>
#include <vector>

#include "compiler/source/source_file.h"

namespace compiler {

enum class LexedKind {
  kName,
  kKeyword,
  kUnit,
  kNumber,
  kText,  // closed or not
  kSign   // operators, brackets; also what has no meaning
};

struct LexedToken {
  LexedKind kind = LexedKind::kName;
  Span span{};  // within the text
};

// Comments are left out.
std::vector<LexedToken> Lex(std::string_view text);

}  // namespace compiler
