#include "compiler/syntax/layout.h"

#include <TaskParser.h>
#include <fmt/format.h>

#include <utility>

#include "compiler/syntax/foreign_words.h"
#include "compiler/syntax/lexical_errors.h"

namespace compiler {
namespace {

using grammar::TaskParser;

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

}  // namespace compiler
