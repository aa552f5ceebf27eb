// A well-formed file token by token, for what works on the written text: the formatter.
#pragma once

#include <optional>
#include <vector>

#include "compiler/source/diagnostic.h"
#include "compiler/source/source_file.h"

namespace compiler {

// What a token does where it stands, as far as this decides how it is set.
enum class TokenRole {
  kWord,          // a name, a keyword, a number, a text
  kOperator,      // between two operands; `=`, `->`, and the `..` between a param's bounds
  kSign,          // the `-` of a negative value or power
  kUnitOperator,  // in `m/s`, but not in `4 / s`
  kUnit,          // the name of a unit
  kPower,         // `^`
  kRange,         // `..` in an index
  kDot,           // `.`
  kComma,         // `,`
  kColon,         // `:`
  kCallOpen,      // `(` after the function's name
  kGroupOpen,     // `(` around an expression
  kIndexOpen,     // `[` after what is indexed, or after the type of an array's elements
  kUnitOpen,      // `[` around a unit
  kSetOpen,       // `{` in an index
  kBracketClose,  // of any of those
  kBlockOpen,     // `{` around statements
  kBlockClose,
};

struct WrittenToken {
  TokenRole role = TokenRole::kWord;
  Span span{};               // within the file's own text
  bool begins_line = false;  // the first token of the header, of a declaration or of a statement
};

// Nothing if the file has syntax errors, which then go to `diagnostics`. Between the tokens there
// is nothing but blanks and comments.
std::optional<std::vector<WrittenToken>> ReadTokens(const SourceFile& source,
                                                    Diagnostics& diagnostics);

}  // namespace compiler
