// The lexer that ANTLR generates from the grammar, with a shorter way for most of a text.
#pragma once

#include <TaskLexer.h>

#include <memory>
#include <string_view>

#include "compiler/syntax/byte_stream.h"

namespace compiler {

// ANTLR's automaton is made anew in each process, state by state, from what it reads: for a single
// task that takes longer than all else of reading it. Blanks, comments, words, numbers, strings and
// all signs that stand for themselves are recognized here; whatever else there is, and all that is
// never well-formed, is left to ANTLR. A test holds the tokens of both against each other.
class QuickLexer : public grammar::TaskLexer {
 public:
  // `bytes` outlives this.
  explicit QuickLexer(ByteStream* bytes) : TaskLexer(bytes), bytes_(*bytes) {}

  std::unique_ptr<antlr4::Token> nextToken() override;

 private:
  // A token without its place; of no length where ANTLR has to say what it is.
  struct Word {
    size_t type = 0;
    size_t length = 0;
    size_t channel = antlr4::Token::DEFAULT_CHANNEL;
  };

  Word First(std::u32string_view rest) const;
  Word FirstSign(std::u32string_view rest) const;
  void SkipBlanks();
  void Advance(size_t count);

  ByteStream& bytes_;
};

}  // namespace compiler
