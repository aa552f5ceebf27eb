// The words of other languages; the list is foreign_words.def.
#pragma once

#include <string_view>

#include "compiler/source/diagnostic.h"

namespace compiler {

// What a word is where it stands: one word may be several.
enum class ForeignPlace {
  kStatement,
  kDeclaration,
  kOperator,
  kOperand,
  kModule,
  kFunction,
  kType,
  kUnit
};

struct ForeignWord {
  ForeignPlace place;
  std::string_view text;
  std::string_view instead;  // what takes its place; empty where more has to change
  std::string_view help;     // empty: "write `instead`"
};

// Null if the word is none of other languages.
const ForeignWord* FindForeign(ForeignPlace place, std::string_view word);

// What to write instead of the word, which stands in `span`; empty if it is none.
Help HelpForForeign(ForeignPlace place, std::string_view word, Span span);

}  // namespace compiler
