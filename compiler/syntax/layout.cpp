#include "compiler/syntax/layout.h"

#include <TaskParser.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compiler/syntax/foreign_words.h"
#include "compiler/syntax/lexical_errors.h"
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

bool IsOpening(TokenType type) {
  return type == TaskParser::LEFT_PARENTHESIS || type == TaskParser::LEFT_BRACKET ||
         type == TaskParser::LEFT_BRACE;
}

bool IsClosing(TokenType type) {
  return type == TaskParser::RIGHT_PARENTHESIS || type == TaskParser::RIGHT_BRACKET ||
         type == TaskParser::RIGHT_BRACE;
}

bool IsPrefix(TokenType type) { return type == TaskParser::NOT || type == TaskParser::MINUS; }

// Words that can begin a line without beginning a statement.
bool ContinuesStatement(TokenType type) {
  return type == TaskParser::LEFT_BRACE || type == TaskParser::ELSE || type == TaskParser::IN ||
         type == TaskParser::PER || type == TaskParser::ARROW || type == TaskParser::WITHIN;
}

bool AnnouncesBlock(TokenType type) {
  return type == TaskParser::IF || type == TaskParser::ELSE || type == TaskParser::ON ||
         type == TaskParser::FOR || type == TaskParser::ONCE || type == TaskParser::TEST ||
         type == TaskParser::PHASE;
}

bool IsBlockContent(TokenType type) {
  return IsStatementKeyword(type) || type == TaskParser::REWARD;
}

bool BeginsStatementBehind(TokenType last) {
  return last == TaskParser::LEFT_BRACE || last == TaskParser::RIGHT_BRACE ||
         last == TaskParser::ELSE || last == TaskParser::OVERRIDE;
}

// What follows makes a name of the word: `log = 3`, `test: real`, `log(x)`; not `require (a)`,
// `observe -a`.
bool IsNameBefore(TokenType word, TokenType next) {
  if (word == TaskParser::FN && next == TaskParser::LEFT_PARENTHESIS) return false;
  if (next == TaskParser::WITHIN) return false;  // a name, or else `word` is not first
  const bool takes_expression = word == TaskParser::REQUIRE || word == TaskParser::EXPECT ||
                                word == TaskParser::RETURN || word == TaskParser::OBSERVE;
  const bool begins_expression = next == TaskParser::LEFT_PARENTHESIS || next == TaskParser::MINUS;
  return FollowsOperand(next) && !(takes_expression && begins_expression);
}

bool IsPartOfUnit(TokenType type) {
  return IsUnit(type) || type == TaskParser::ANY_UNIT || type == TaskParser::NUMBER ||
         type == TaskParser::TIMES || type == TaskParser::DIVIDE || type == TaskParser::POWER ||
         type == TaskParser::MINUS;
}

std::string Quoted(TokenType type) { return fmt::format("`{}`", Spelling(type)); }

}  // namespace

TokenList Layout::Run(antlr4::Lexer& lexer) {
  std::unique_ptr<antlr4::Token> next = NextToken(lexer);
  size_t skipped_line = 0;
  while (result_.is_parseable) {
    std::unique_ptr<antlr4::Token> token = std::move(next);
    const bool is_end = token->getType() == antlr4::Token::EOF;
    if (!is_end) next = NextToken(lexer);
    if (!is_end && token->getLine() == skipped_line) continue;
    if (token->getType() == TaskParser::DOC_COMMENT) {
      AddDocumentation(*token);
      continue;
    }
    auto& common = static_cast<antlr4::CommonToken&>(*token);
    const Repair repair = RepairToken(common, last_, report_);
    if (repair == Repair::kSkipLine) skipped_line = token->getLine();
    if (repair != Repair::kKeep) continue;
    token.release();
    Add(std::unique_ptr<antlr4::CommonToken>(&common), next.get());
    if (next == nullptr) break;
  }
  return std::move(result_);
}

// A string that is not closed swallows the braces behind it, which are then read again.
std::unique_ptr<antlr4::Token> Layout::NextToken(antlr4::Lexer& lexer) {
  std::unique_ptr<antlr4::Token> token = lexer.nextToken();
  if (token->getType() != TaskParser::UNCLOSED_STRING) return token;
  const uint32_t end = EndOfUnclosedString(SpanOf(*token), report_.source());
  if (end == SpanOf(*token).end) return token;
  static_cast<antlr4::CommonToken&>(*token).setStopIndex(end - 1);
  lexer.getInputStream()->seek(end);
  lexer.hitEOF = false;
  return token;
}

void Layout::Add(std::unique_ptr<antlr4::CommonToken> token, const antlr4::Token* next) {
  MendOperator(*token, next);
  ClassifyWord(*token, next != nullptr ? next->getType() : 0);
  const TokenType type = token->getType();
  const bool is_first_in_line = last_ == nullptr || token->getLine() != last_->getLine();
  if (last_ != nullptr && (is_first_in_line || type == antlr4::Token::EOF)) BeginLine(*token);
  const bool begins_block =
      type == TaskParser::LEFT_BRACE && IsInBrackets() && EndsOperand(last_->getType());
  if (begins_block) EndExpression(*token);
  if (IsClosing(type) && !Close(*token, next)) return;
  if (IsOpening(type)) Open(*token);
  if (!ExpectBlock(*token, next == nullptr || next->getLine() != token->getLine())) return;
  RejectForeignLoop(*token);
  CountNesting(*token);
  if (type == TaskParser::ALLOW) allow_line_ = token->getLine();
  if (type == TaskParser::SET) is_in_set_ = true;
  if (!doc_.empty() && token->getLine() != allow_line_) {
    result_.docs[SpanOf(*token).begin] = std::exchange(doc_, "");
  }
  last_ = token.get();
  result_.tokens.push_back(std::move(token));
}

// `a AND b`: a name can stand neither behind an operand nor before one.
void Layout::MendOperator(antlr4::CommonToken& token, const antlr4::Token* next) {
  const bool is_between = token.getType() == TaskParser::NAME && last_ != nullptr &&
                          EndsOperand(last_->getType()) && last_->getLine() == token.getLine() &&
                          next != nullptr && StartsOperand(next->getType());
  if (!is_between) return;
  const std::string word = token.getText();
  const ForeignWord* foreign = FindForeign(ForeignPlace::kOperator, word);
  const bool is_and = foreign != nullptr && foreign->instead == Spelling(TaskParser::AND);
  const bool is_or = foreign != nullptr && foreign->instead == Spelling(TaskParser::OR);
  if (!is_and && !is_or) return;
  Diagnostic diagnostic =
      MakeDiagnostic(code::kForeignSyntax, SpanOf(token),
                     fmt::format("`{}` is not part of the task language", word));
  diagnostic.help = HelpForForeign(ForeignPlace::kOperator, word, SpanOf(token));
  report_.AddMended(std::move(diagnostic));
  token.setType(is_and ? TaskParser::AND : TaskParser::OR);
}

// ---- Words -------------------------------------------------------------------------------------

void Layout::ClassifyWord(antlr4::CommonToken& token, TokenType next) {
  const TokenType type = token.getType();
  if (type == TaskParser::WITHIN && !IsBetweenOperands(next)) token.setType(TaskParser::NAME);
  if (type == TaskParser::ANY_UNIT && !IsInUnitOfType()) token.setType(TaskParser::NAME);
  if (!IsContextualKeyword(type)) return;
  if (!CanBeginStatement(token) || IsNameBefore(type, next)) token.setType(TaskParser::NAME);
}

// What is called `within` is behind no operand, or else set: `within = 3`.
bool Layout::IsBetweenOperands(TokenType next) const {
  const bool may_begin_operand = next == TaskParser::LEFT_PARENTHESIS ||
                                 next == TaskParser::MINUS || next == TaskParser::WITHIN;
  const bool is_name = FollowsOperand(next) && !may_begin_operand;
  return !is_name && last_ != nullptr && EndsOperand(last_->getType());
}

// Behind `: real [` or `-> real[4] [`, and what a unit consists of.
bool Layout::IsInUnitOfType() const {
  const auto type_before = [this](size_t index) {
    return index <= result_.tokens.size() ? result_.tokens[result_.tokens.size() - index]->getType()
                                          : TokenType{0};
  };
  size_t at = 1;
  while (IsPartOfUnit(type_before(at))) ++at;
  if (type_before(at) != TaskParser::LEFT_BRACKET) return false;
  // The index of an array, between its own brackets.
  if (type_before(at + 1) == TaskParser::RIGHT_BRACKET &&
      type_before(at + 3) == TaskParser::LEFT_BRACKET) {
    at += 3;
  }
  const TokenType behind = type_before(at + 2);
  return type_before(at + 1) == TaskParser::NAME &&
         (behind == TaskParser::COLON || behind == TaskParser::ARROW);
}

bool Layout::CanBeginStatement(const antlr4::CommonToken& token) const {
  if (last_ == nullptr) return true;
  const TokenType last = last_->getType();
  const bool is_first_in_line = token.getLine() != last_->getLine();
  if (EndsOperand(last)) return is_first_in_line || !IsInBrackets();
  if (BeginsStatementBehind(last)) return !ContinuesPhase(last);
  return is_first_in_line && !IsInBrackets() && !ExpectsOperand(last);
}

bool Layout::ContinuesPhase(TokenType type) const {
  return block_head_ == TaskParser::PHASE &&
         (type == TaskParser::WITHIN || type == TaskParser::ELSE);
}

bool Layout::ExpectBlock(const antlr4::CommonToken& token, bool ends_line) {
  const TokenType type = token.getType();
  if (ContinuesPhase(type)) return true;
  const bool begins_statement = last_ == nullptr || token.getLine() != last_->getLine() ||
                                BeginsStatementBehind(last_->getType());
  if (AnnouncesBlock(type) && begins_statement) {
    block_head_ = type;
  } else if (block_head_ == TaskParser::ONCE && type == TaskParser::IF) {
    block_head_ = TaskParser::IF;
  } else if (block_head_ == TaskParser::FOR && type == TaskParser::IN) {
    block_head_ = TaskParser::IN;
  } else if (block_head_ != 0 && EndsOperand(last_->getType()) && IsBlockContent(type)) {
    block_head_ = 0;  // `if a reward b = 1`
    braceless_line_ = token.getLine();
  } else if (block_head_ != 0 && type == TaskParser::COLON && !IsInBrackets()) {
    Diagnostic diagnostic =
        MakeDiagnostic(code::kUnexpectedToken, SpanOf(token), "expected `{`, found `:`");
    diagnostic.help = "write blocks in braces";
    report_.AddUnlessFaulty(std::move(diagnostic));
    return !ends_line;  // else the end of the line opens the block
  }
  return true;
}

// `for (i = 0; i < 3; i++)`: the signs in the rest of the line would only add to the confusion.
void Layout::RejectForeignLoop(const antlr4::CommonToken& token) {
  const bool is_in_loop = token.getType() == TaskParser::LEFT_PARENTHESIS && last_ != nullptr &&
                          last_->getType() == TaskParser::FOR;
  if (!is_in_loop) return;
  Diagnostic diagnostic =
      MakeDiagnostic(code::kForeignSyntax, SpanOf(token), "a loop has no parentheses");
  diagnostic.help = "it iterates over a set: `for i in 0..3 { ... }`";
  report_.Add(std::move(diagnostic));
  report_.IgnoreLine(SpanOf(token));
}

// An empty token behind the last one.
void Layout::AddSynthetic(TokenType type) {
  auto token = std::make_unique<antlr4::CommonToken>(type);
  const size_t place = last_->getStopIndex() + 1;
  token->setStartIndex(place);
  token->setStopIndex(place - 1);
  token->setLine(last_->getLine());
  last_ = token.get();
  result_.tokens.push_back(std::move(token));
}

// `///` behind something in the same line, and `////`, are ordinary comments.
void Layout::AddDocumentation(const antlr4::Token& token) {
  if (last_ != nullptr && last_->getLine() == token.getLine()) return;
  const Span span = SpanOf(token);
  std::string text(report_.source().TextOf({span.begin + 3, span.end}));
  if (text.starts_with('/')) return;
  if (text.starts_with(' ')) text.erase(0, 1);
  text.erase(text.find_last_not_of(" \t\f") + 1);
  if (!doc_.empty()) doc_ += '\n';
  doc_ += text;
}

// ---- Lines -------------------------------------------------------------------------------------

void Layout::BeginLine(const antlr4::CommonToken& next) {
  const TokenType type = next.getType();
  const bool is_end = type == antlr4::Token::EOF;
  const bool is_keyword = IsStatementKeyword(type) || IsDeclarationKeyword(type);
  if (IsInBrackets()) {
    const bool begins_statement =
        is_end || is_keyword || (EndsOperand(last_->getType()) && StartsOperand(type));
    if (!begins_statement) return;
    EndExpression(next);
    if (!is_keyword) report_.MarkFaulty(SpanOf(next));  // perhaps the rest of the expression
  }
  const bool is_headed = EndsOperand(last_->getType()) || last_->getType() == TaskParser::ELSE;
  const bool continues_head = type == TaskParser::LEFT_BRACE || ContinuesPhase(type);
  if (block_head_ != 0 && is_headed && !continues_head) OpenMissingBlock();
  // An `allow` may stand above a declaration as well as above a statement.
  const bool begins_declaration = IsDeclarationKeyword(type) && type != TaskParser::ALLOW;
  const bool ends_block = is_end || (begins_declaration && !open_.empty() &&
                                     IndentationOf(next) <= open_.front().indentation);
  if (ends_block) CloseUnclosed(0, next);
  const TokenType last = last_->getType();
  if (is_end || ContinuesStatement(type) || ExpectsOperand(last)) return;
  if (last == TaskParser::LEFT_BRACE || last == TaskParser::LINE_END) return;
  if (EndsOperand(last) && FollowsOperand(type)) {
    RejectBrokenLine(next);
  } else {
    AddSynthetic(TaskParser::LINE_END);
    block_head_ = 0;
    is_in_set_ = false;
  }
}

void Layout::OpenMissingBlock() {
  const uint32_t place = SpanOf(*last_).end;
  report_.AddUnlessFaulty(
      MakeDiagnostic(code::kUnexpectedToken, {place, place},
                     fmt::format("expected {}, found the end of the line", MissingBlockHead())));
  block_head_ = 0;
  const uint32_t indentation = IndentationOf(*last_);
  AddSynthetic(TaskParser::LEFT_BRACE);
  open_.push_back({TaskParser::LEFT_BRACE, {place, place}, true, 1, indentation, true});
  ++nesting_;
}

std::string Layout::MissingBlockHead() const {
  switch (block_head_) {
    case TaskParser::ONCE:
      return "`if` and a condition";
    case TaskParser::FOR:
      return "`in` and a set";
    default:
      return "`{`";
  }
}

void Layout::EndExpression(const antlr4::CommonToken& next) {
  const auto block = std::find_if(open_.rbegin(), open_.rend(),
                                  [](const Bracket& bracket) { return bracket.is_block; });
  CloseUnclosed(static_cast<size_t>(open_.rend() - block), next);
}

// The line is joined to the one above, as was probably meant.
void Layout::RejectBrokenLine(const antlr4::CommonToken& next) {
  Diagnostic diagnostic =
      MakeDiagnostic(code::kBrokenLine, SpanOf(next),
                     fmt::format("a line cannot begin with {}", Quoted(next.getType())));
  diagnostic.labels.push_back({SpanOf(*last_), "the statement ends here"});
  diagnostic.help =
      "to continue the line above, put the operator at its end, or the whole in parentheses";
  report_.AddUnlessFaulty(std::move(diagnostic));
  report_.MarkFaulty(SpanOf(*last_));
}

uint32_t Layout::IndentationOf(const antlr4::Token& token) {
  const auto number = static_cast<uint32_t>(token.getLine());
  if (number != measured_line_) {
    const std::string_view line = report_.source().Line(number);
    measured_line_ = number;
    indentation_ = static_cast<uint32_t>(std::min(line.find_first_not_of(" \t"), line.size()));
  }
  return indentation_;
}

// ---- Brackets ----------------------------------------------------------------------------------

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
