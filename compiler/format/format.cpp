#include "compiler/format/format.h"

#include <utility>
#include <vector>

#include "base/text/utf8.h"
#include "compiler/format/gap.h"
#include "compiler/format/line_list.h"
#include "compiler/syntax/spacing.h"
#include "compiler/syntax/written_tokens.h"

namespace compiler {
namespace {

constexpr uint32_t kIndentation = 2;
constexpr uint32_t kContinuation = 4;  // of a statement's further lines

// Sets a file token by token.
class Formatter {
 public:
  Formatter(std::string_view text, const std::vector<WrittenToken>& tokens)
      : text_(text), tokens_(tokens) {}

  std::string Run() {
    for (at_ = 0; at_ < tokens_.size(); ++at_) {
      const bool follows_comment = WriteComments();
      WriteToken(follows_comment);
    }
    WriteComments();
    const bool has_carriage_returns = text_.find("\r\n") != std::string_view::npos;
    return lines_.Join(has_carriage_returns ? "\r\n" : "\n");
  }

 private:
  // ---- What was written ----

  std::string_view TextOf(const WrittenToken& token) const {
    return text_.substr(token.span.begin, token.span.end - token.span.begin);
  }

  // In front of a token, or at the end of the file.
  std::string_view GapBefore(size_t index) const {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    const size_t first = text_.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
    const size_t begin = index == 0 ? first : tokens_[index - 1].span.end;
    const size_t end = index == tokens_.size() ? text_.size() : tokens_[index].span.begin;
    return text_.substr(begin, end - begin);
  }

  // The index of the brace that closes the block.
  size_t EndOfBlock(size_t open) const {
    size_t depth = 0;
    for (size_t i = open;; ++i) {
      if (tokens_[i].role == TokenRole::kBlockOpen) ++depth;
      if (tokens_[i].role == TokenRole::kBlockClose && --depth == 0) return i;
    }
  }

  // How many statements the block has, not counting those of inner blocks.
  size_t CountStatements(size_t open, size_t close) const {
    size_t count = 0;
    for (size_t i = open + 1; i < close; ++i) {
      if (tokens_[i].role == TokenRole::kBlockOpen) i = EndOfBlock(i);
      if (tokens_[i].begins_line) ++count;
    }
    return count;
  }

  // Is the block written in one line, short enough to be left there?
  bool IsOneLine(size_t open) const {
    const size_t close = EndOfBlock(open);
    uint32_t width = lines_.width() + text::DisplayWidth(TextOf(tokens_[open]));
    for (size_t i = open + 1; i <= close; ++i) {
      if (GapBefore(i).find_first_of("\r\n") != std::string_view::npos) return false;
      if (IsSpaced(tokens_[i - 1].role, tokens_[i].role)) ++width;
      width += text::DisplayWidth(TextOf(tokens_[i]));
    }
    return width <= kLineWidth && CountStatements(open, close) <= 1;
  }

  // ---- What is set ----

  uint32_t Indentation() const { return kIndentation * depth_; }

  bool IsFirstInBlock() const { return at_ > 0 && tokens_[at_ - 1].role == TokenRole::kBlockOpen; }

  // The comments in front of the current token. True if a line must begin behind them.
  bool WriteComments() {
    gap_ = ReadGap(GapBefore(at_));
    bool is_first = true;
    for (const Comment& comment : gap_.comments) {
      if (comment.line_breaks == 0 && is_first && at_ > 0) {
        lines_.AddTrailingComment(comment.text);
      } else {
        lines_.Begin(
            IsInStatement() ? Indentation() + kContinuation : Indentation(),
            comment.line_breaks > 1 && !IsInStatement() && !(is_first && IsFirstInBlock()));
        lines_.Append(comment.text);
      }
      is_first = false;
    }
    return !gap_.comments.empty();
  }

  // Is the current token in the middle of a statement, rather than its first or a block's brace?
  bool IsInStatement() const {
    return at_ < tokens_.size() && !tokens_[at_].begins_line &&
           tokens_[at_].role != TokenRole::kBlockOpen &&
           tokens_[at_].role != TokenRole::kBlockClose && TextOf(tokens_[at_]) != "else";
  }

  void WriteToken(bool follows_comment) {
    const WrittenToken& token = tokens_[at_];
    if (token.role == TokenRole::kBlockClose) --depth_;
    if (follows_comment || BeginsLine(token)) {
      lines_.Begin(IndentationOf(token), IsAfterBlankLine(token, follows_comment));
    } else if (IsSpaced(tokens_[at_ - 1].role, token.role)) {
      lines_.Append(" ");
    }
    if (token.role == TokenRole::kBlockOpen) OpenBlock();
    lines_.Append(TextOf(token));
    if (token.role == TokenRole::kBlockClose && at_ == one_line_end_) one_line_end_ = 0;
  }

  void OpenBlock() {
    ++depth_;
    if (!IsInOneLine() && IsOneLine(at_)) one_line_end_ = EndOfBlock(at_);
  }

  bool IsInOneLine() const { return one_line_end_ != 0; }

  bool BeginsLine(const WrittenToken& token) const {
    if (at_ == 0) return true;
    if (IsInOneLine()) return false;
    const WrittenToken& before = tokens_[at_ - 1];
    if (token.begins_line) return true;
    if (token.role == TokenRole::kBlockClose) return before.role != TokenRole::kBlockOpen;
    if (token.role == TokenRole::kBlockOpen || TextOf(token) == "else") return false;
    return gap_.line_breaks > 0 && MayBreak(before.role, token.role);
  }

  uint32_t IndentationOf(const WrittenToken& token) const {
    const bool continues = IsInStatement() && token.role != TokenRole::kBracketClose;
    return Indentation() + (continues ? kContinuation : 0);
  }

  bool IsAfterBlankLine(const WrittenToken& token, bool follows_comment) const {
    return token.begins_line && gap_.line_breaks > 1 && (follows_comment || !IsFirstInBlock());
  }

  std::string_view text_;
  const std::vector<WrittenToken>& tokens_;
  LineList lines_;
  Gap gap_;
  size_t at_ = 0;
  uint32_t depth_ = 0;       // of blocks
  size_t one_line_end_ = 0;  // the brace that closes the block in one line; 0: there is none
};

}  // namespace

std::optional<std::string> Format(const SourceFile& source, Diagnostics& diagnostics) {
  const auto tokens = ReadTokens(source, diagnostics);
  if (!tokens) return std::nullopt;
  return Formatter(source.text(), *tokens).Run();
}

}  // namespace compiler
