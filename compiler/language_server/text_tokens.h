// The tokens of a text that is being written, and how they lie in it.
#pragma once

#include <string_view>
#include <vector>

#include "compiler/syntax/lexed_tokens.h"

namespace compiler {

class TextTokens {
 public:
  // `text` must outlive this.
  explicit TextTokens(std::string_view text);

  std::string_view text() const { return text_; }
  size_t size() const { return tokens_.size(); }
  const LexedToken& operator[](size_t index) const { return tokens_[index]; }
  // "" where there is no such token.
  std::string_view TextOf(size_t index) const;
  bool Is(size_t index, std::string_view spelling) const { return TextOf(index) == spelling; }
  LexedKind KindOf(size_t index) const { return tokens_[index].kind; }
  bool IsName(size_t index) const {
    return index < size() && tokens_[index].kind == LexedKind::kName;
  }

  // How many tokens end at `offset` or before.
  size_t CountBefore(uint32_t offset) const;

  // Is it the first token of its line?
  bool BeginsLine(size_t index) const { return index == 0 || IsLineBetween(index - 1, index); }
  // Does a line end between the two?
  bool IsLineBetween(size_t left, size_t right) const;
  // An operator, a comma, an opening bracket: something must follow.
  bool ExpectsMore(size_t index) const;
  // Does a brace stand around statements, rather than around a set?
  bool IsBlockOpen(size_t index) const;

 private:
  std::string_view text_;
  std::vector<LexedToken> tokens_;
};

}  // namespace compiler
