#include "compiler/syntax/syntax_failure.h"

#include <TaskParser.h>
#include <fmt/format.h>

#include <utility>

namespace compiler {

using grammar::TaskParser;

bool Failure::is_at_line_start() const {
  return last == nullptr || last_type() == TaskParser::LINE_END ||
         last->getLine() != found.getLine();
}

bool Failure::is_behind_last() const {
  if (last == nullptr) return false;
  if (type() == TaskParser::LINE_END || type() == antlr4::Token::EOF) return true;
  const bool is_complete =
      last_type() == TaskParser::LINE_END || last_type() == TaskParser::LEFT_BRACE;
  return !is_complete && last->getLine() != found.getLine();
}

namespace {

// The first token since a line's end or a brace.
const antlr4::Token* StatementBefore(antlr4::TokenStream& tokens, size_t index) {
  while (index > 0) {
    switch (tokens.get(index - 1)->getType()) {
      case TaskParser::LINE_END:
      case TaskParser::LEFT_BRACE:
      case TaskParser::RIGHT_BRACE:
        return tokens.get(index);
      default:
        --index;
    }
  }
  return tokens.size() > 0 ? tokens.get(0) : nullptr;
}

}  // namespace

Failure MakeFailure(antlr4::Parser& parser, antlr4::Token& found, const SourceFile& file) {
  antlr4::TokenStream& tokens = *parser.getTokenStream();
  const size_t index = found.getTokenIndex();
  auto* context = parser.getContext();
  const auto* parent = dynamic_cast<const antlr4::ParserRuleContext*>(context->parent);
  const antlr4::Token* begin = context->getStart();
  const size_t begin_index = begin != nullptr ? begin->getTokenIndex() : 0;
  return {parser,
          file,
          found,
          index >= 2 ? tokens.get(index - 2) : nullptr,
          index >= 1 ? tokens.get(index - 1) : nullptr,
          index + 1 < tokens.size() ? tokens.get(index + 1) : nullptr,
          begin,
          begin_index >= 1 ? tokens.get(begin_index - 1) : nullptr,
          StatementBefore(tokens, index),
          context->getRuleIndex(),
          parent != nullptr ? parent->getRuleIndex() : size_t{TaskParser::RuleFile}};
}

std::string FoundText(const Failure& failure) {
  switch (failure.type()) {
    case antlr4::Token::EOF:
      return "the end of the file";
    case TaskParser::LINE_END:
      return "the end of the line";
    case TaskParser::STRING:
      return "a string";
    default:
      // Braces that the layout has added are empty.
      return failure.found.getText().empty() ? "the end of the line"
                                             : fmt::format("`{}`", failure.found.getText());
  }
}

Span PlaceBehindLast(const Failure& failure) {
  const uint32_t place = SpanOf(*failure.last).end;
  return {place, place};
}

Diagnostic Expected(const Failure& failure, const std::string& what) {
  if (failure.is_behind_last()) return ExpectedBehindLast(failure, what);
  return MakeDiagnostic(code::kUnexpectedToken, SpanOf(failure.found),
                        fmt::format("expected {}, found {}", what, FoundText(failure)));
}

Diagnostic ExpectedBehindLast(const Failure& failure, const std::string& what) {
  return MakeDiagnostic(code::kUnexpectedToken, PlaceBehindLast(failure),
                        fmt::format("expected {}, found {}", what, FoundText(failure)));
}

Diagnostic WithHelp(Diagnostic diagnostic, Help help) {
  diagnostic.help = std::move(help);
  return diagnostic;
}

}  // namespace compiler
