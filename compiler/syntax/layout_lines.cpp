// Where a line ends a statement, and where a block is missing.
#include <TaskParser.h>
#include <fmt/format.h>

#include <algorithm>

#include "compiler/syntax/layout.h"

namespace compiler {
namespace {

using grammar::TaskParser;

// Words that can begin a line without beginning a statement.
bool ContinuesStatement(TokenType type) {
  return type == TaskParser::LEFT_BRACE || type == TaskParser::ELSE || type == TaskParser::IN ||
         type == TaskParser::PER || type == TaskParser::ARROW || type == TaskParser::WITHIN;
}

}  // namespace

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

}  // namespace compiler
