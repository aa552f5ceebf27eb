// Which brackets belong together, and what is done about those that do not.
#include <TaskParser.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compiler/syntax/layout.h"
#include "compiler/syntax/parse.h"

namespace compiler {
namespace {

using grammar::TaskParser;

TokenType ClosingOf(TokenType opening) {
  switch (opening) {
    case TaskParser::LEFT_PARENTHESIS:
      return TaskParser::RIGHT_PARENTHESIS;
    case TaskParser::LEFT_BRACKET:
      return TaskParser::RIGHT_BRACKET;
    default:
      return TaskParser::RIGHT_BRACE;
  }
}

bool IsPrefix(TokenType type) { return type == TaskParser::NOT || type == TaskParser::MINUS; }

}  // namespace

void Layout::Open(antlr4::CommonToken& token) {
  const bool is_block = token.getType() == TaskParser::LEFT_BRACE && !IsInBrackets() && !IsSet();
  if (is_block) block_head_ = 0;
  const Span span = SpanOf(token);
  const uint32_t nesting = 1 + std::exchange(prefix_run_, 0);
  open_.push_back(
      {token.getType(), span, is_block, nesting, is_block ? IndentationOf(token) : 0, false});
  nesting_ += nesting;
  if (token.getType() == TaskParser::LEFT_BRACE && !is_block) token.setType(TaskParser::SET_BEGIN);
}

bool Layout::IsSet() const {
  if (last_ == nullptr) return false;
  if (block_head_ == TaskParser::IN && last_->getType() == TaskParser::IN) return true;
  return (block_head_ == TaskParser::IN || is_in_set_) && ExpectsOperand(last_->getType());
}

bool Layout::Close(antlr4::CommonToken& token, const antlr4::Token* next) {
  const TokenType type = token.getType();
  const bool is_first_in_line = last_ == nullptr || token.getLine() != last_->getLine();
  // `if a reward b = 1 }`: the parser reports the missing brace.
  const bool is_braceless = block_head_ != 0 || token.getLine() == braceless_line_;
  if (type == TaskParser::RIGHT_BRACE && !IsInBrackets() && is_braceless) {
    block_head_ = 0;
    braceless_line_ = 0;
    return false;
  }
  if (type == TaskParser::RIGHT_BRACE && is_first_in_line) CloseMissingBlocks(token);
  // A block is never closed by another bracket than its own.
  size_t index = open_.size();
  while (index > 0 && ClosingOf(open_[index - 1].type) != type) {
    if (open_[index - 1].is_block) index = 1;
    --index;
  }
  if (index == 1 && next != nullptr && IsOneTooMany(*next)) {
    ReportUnmatched(token);
    return false;
  }
  if (index > 0) {
    CloseUnclosed(index, token);
    const Bracket& bracket = open_.back();
    if (bracket.is_block && is_first_in_line && IndentationOf(token) < bracket.indentation) {
      suspects_.push_back(bracket);
    }
    if (type == TaskParser::RIGHT_BRACE && !bracket.is_block) token.setType(TaskParser::SET_END);
    Pop();
    return true;
  }
  const auto expected = std::ranges::find(synthetic_closings_, type);
  if (expected != synthetic_closings_.end()) {
    synthetic_closings_.erase(expected);
    return false;
  }
  if (!IsInBrackets()) {
    ReportUnmatched(token);
    return false;
  }
  const Bracket& bracket = open_.back();
  const TokenType closing = ClosingOf(bracket.type);
  Diagnostic diagnostic =
      MakeDiagnostic(code::kUnmatchedBracket, SpanOf(token),
                     fmt::format("{} does not close {}", Quoted(type), Quoted(bracket.type)));
  diagnostic.labels.push_back({bracket.span, "opened here"});
  diagnostic.help = WriteInstead(SpanOf(token), Spelling(closing));
  token.setType(closing == TaskParser::RIGHT_BRACE ? size_t{TaskParser::SET_END} : closing);
  Pop();
  report_.AddUnlessFaulty(std::move(diagnostic));
  return true;
}

void Layout::ReportUnmatched(const antlr4::CommonToken& token) {
  Diagnostic diagnostic = MakeDiagnostic(code::kUnmatchedBracket, SpanOf(token),
                                         fmt::format("{} closes nothing", Quoted(token.getType())));
  diagnostic.help = {"remove it, or add the opening bracket that belongs to it",
                     {{SpanOf(token), ""}}};
  report_.AddUnlessFaulty(std::move(diagnostic));
}

// A brace that would close the outermost block, although `next` goes on inside of it.
bool Layout::IsOneTooMany(const antlr4::Token& next) {
  const Bracket& block = open_.front();
  const TokenType type = next.getType();
  if (!block.is_block || type == antlr4::Token::EOF || type == TaskParser::RIGHT_BRACE ||
      type == TaskParser::DOC_COMMENT || IsDeclarationKeyword(type)) {
    return false;
  }
  return next.getLine() == last_->getLine() || IndentationOf(next) > block.indentation;
}

// Blocks without an opening brace may have no closing one either.
void Layout::CloseMissingBlocks(const antlr4::CommonToken& closing) {
  while (!open_.empty() && open_.back().is_synthetic &&
         IndentationOf(closing) < open_.back().indentation) {
    AddSynthetic(TaskParser::RIGHT_BRACE);
    Pop();
  }
}

void Layout::CloseUnclosed(size_t index, const antlr4::CommonToken& next) {
  const auto opened = std::find_if(open_.rbegin(), open_.rend() - static_cast<ptrdiff_t>(index),
                                   [](const Bracket& bracket) { return !bracket.is_synthetic; });
  if (opened != open_.rend() - static_cast<ptrdiff_t>(index)) ReportUnclosed(*opened, next);
  while (open_.size() > index) {
    const Bracket& unclosed = open_.back();
    const TokenType type = ClosingOf(unclosed.type);
    if (!unclosed.is_synthetic) synthetic_closings_.push_back(type);
    AddSynthetic(type == TaskParser::RIGHT_BRACE && !unclosed.is_block ? size_t{TaskParser::SET_END}
                                                                       : type);
    Pop();
  }
}

void Layout::ReportUnclosed(const Bracket& bracket, const antlr4::CommonToken& next) {
  const Bracket* suspect = bracket.is_block && !suspects_.empty() ? &suspects_.front() : nullptr;
  const std::string closing = Quoted(ClosingOf(bracket.type));
  const std::string found = next.getType() == antlr4::Token::EOF
                                ? "the end of the file"
                                : fmt::format("`{}`", next.getText());
  const uint32_t place = SpanOf(*last_).end;
  Diagnostic diagnostic = MakeDiagnostic(code::kUnclosedBracket, {place, place},
                                         fmt::format("expected {} before {}", closing, found));
  diagnostic.labels.push_back({suspect != nullptr ? suspect->span : bracket.span,
                               suspect != nullptr ? "this block may be the one that is not closed"
                                                  : "this bracket is not closed"});
  report_.AddUnlessFaulty(std::move(diagnostic));
  // What the parser says of the line with the bracket would be about the same mistake.
  report_.MarkFaulty(suspect != nullptr ? suspect->span : bracket.span);
}

void Layout::Pop() {
  nesting_ -= open_.back().nesting;
  open_.pop_back();
  if (open_.empty()) suspects_.clear();
}

void Layout::CountNesting(const antlr4::CommonToken& token) {
  const TokenType type = token.getType();
  if (!IsOpening(type)) prefix_run_ = IsPrefix(type) ? prefix_run_ + 1 : 0;
  if (nesting_ + prefix_run_ <= kMaxNesting) return;
  Diagnostic diagnostic =
      MakeDiagnostic(code::kTooDeep, SpanOf(token),
                     fmt::format("brackets and signs are nested more than {} deep", kMaxNesting));
  diagnostic.help = "give parts of it a name with `let`";
  report_.Add(std::move(diagnostic));
  result_.is_parseable = false;
}

}  // namespace compiler
