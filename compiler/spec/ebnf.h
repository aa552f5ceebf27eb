// The grammar of the language as other programs and people read it: the EBNF of the W3C, as in the
// definition of XML, written from the ANTLR grammar that the parser is made of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace compiler {

struct GrammarRule {
  std::string name;
  std::string definition;  // `"task" name ("for" name)? end_of_line?`
  std::string comment;     // what stands above it in the grammar, mostly examples; may be empty
  bool is_token = false;   // no blanks between its parts
};

// The rules that `file` leads to, in the order of the grammar, and the comments that may stand
// between tokens. Words and signs stand where they are used, in quotes. `grammar`: the text of
// grammar/Task.g4.
std::vector<GrammarRule> ReadGrammar(std::string_view grammar);

// One rule below the other, each after its comment.
std::string ToEbnf(const std::vector<GrammarRule>& rules);

}  // namespace compiler
