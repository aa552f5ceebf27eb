#include "compiler/syntax/syntax_errors.h"

#include <TaskParser.h>

#include <exception>

#include "compiler/syntax/syntax_messages.h"

namespace compiler {
namespace {

using grammar::TaskParser;

bool IsFirstInLine(antlr4::TokenStream& tokens) {
  const antlr4::Token* previous = tokens.LT(-1);
  return previous == nullptr || previous->getLine() != tokens.LT(1)->getLine();
}

// A rule that loops over statements in braces.
bool IsBlock(size_t rule) {
  return rule == TaskParser::RuleBlock || rule == TaskParser::RuleBody ||
         rule == TaskParser::RuleTestBlock;
}

// What parses the block of the declaration that begins with `first`; nothing if it has none.
std::function<void()> BlockParserOf(antlr4::Parser& parser, const antlr4::Token& first) {
  auto& generated = static_cast<TaskParser&>(parser);
  TokenType head = first.getType();
  if (head == TaskParser::OVERRIDE) {
    head = parser.getTokenStream()->get(first.getTokenIndex() + 1)->getType();
  }
  switch (head) {
    case TaskParser::ON:
    case TaskParser::START:
      return [&generated] { generated.block(); };
    case TaskParser::FN:
      return [&generated] { generated.body(); };
    case TaskParser::TEST:
      return [&generated] { generated.testBlock(); };
    default:
      return nullptr;
  }
}

std::function<void()> StatementsParser(antlr4::Parser& parser) {
  return [&parser] { static_cast<TaskParser&>(parser).block(); };
}

}  // namespace

antlr4::Token* SyntaxErrors::recoverInline(antlr4::Parser* parser) {
  throw antlr4::InputMismatchException(parser);
}

void SyntaxErrors::recover(antlr4::Parser* parser, std::exception_ptr error) {
  is_recovering_ = false;
  switch (parser->getContext()->getRuleIndex()) {
    case TaskParser::RuleHeader:
      Skip(*parser, false, nullptr);
      break;
    case TaskParser::RuleDeclaration:
      Skip(*parser, false, BlockParserOf(*parser, *parser->getContext()->getStart()));
      break;
    case TaskParser::RuleStatement:
      Skip(*parser, true, StatementsParser(*parser));
      break;
    case TaskParser::RuleAllow:
    case TaskParser::RuleBodyStatement:
    case TaskParser::RuleTestStatement:
      Skip(*parser, true, nullptr);
      break;
    default:
      is_recovering_ = true;  // until a rule above has recovered
      std::rethrow_exception(error);
  }
}

void SyntaxErrors::sync(antlr4::Parser* parser) {
  const size_t rule = parser->getContext()->getRuleIndex();
  if (rule != TaskParser::RuleFile && !IsBlock(rule)) return;
  antlr4::TokenStream& tokens = *parser->getTokenStream();
  const antlr4::atn::ATN& atn = parser->getATN();
  const antlr4::misc::IntervalSet expected = atn.nextTokens(atn.states[parser->getState()]);
  while (!expected.contains(tokens.LA(1)) && tokens.LA(1) != antlr4::Token::EOF) {
    Report(*parser, *tokens.LT(1));
    parser->consume();
    Skip(*parser, IsBlock(rule),
         rule == TaskParser::RuleBlock ? StatementsParser(*parser) : nullptr);
  }
}

void SyntaxErrors::reportError(antlr4::Parser* parser, const antlr4::RecognitionException& error) {
  if (is_recovering_) return;
  is_recovering_ = true;
  Report(*parser, *error.getOffendingToken());
}

void SyntaxErrors::Report(antlr4::Parser& parser, antlr4::Token& found) {
  Diagnostic diagnostic = DescribeSyntaxError(parser, found, report_.source());
  const bool is_unit_as_name = diagnostic.code == code::kReservedName && IsUnit(found.getType());
  if (is_unit_as_name) refused_units_.insert(found.getType());
  // `m` where a value is wanted, after `memory m: mat3 = 0` has been refused.
  if (!is_unit_as_name && refused_units_.contains(found.getType()))
    return report_.MarkFaulty(diagnostic.span);
  report_.AddUnlessFaulty(std::move(diagnostic));
}

void SyntaxErrors::Skip(antlr4::Parser& parser, bool is_in_block, const BlockParser& parse_block) {
  antlr4::TokenStream& tokens = *parser.getTokenStream();
  int depth = 0;
  for (TokenType type = tokens.LA(1); type != antlr4::Token::EOF; type = tokens.LA(1)) {
    if (depth == 0) {
      if (is_in_block && type == TaskParser::RIGHT_BRACE) return;
      const bool begins_next = is_in_block ? IsStatementKeyword(type) && type != TaskParser::ELSE
                                           : IsDeclarationKeyword(type);
      if (begins_next && IsFirstInLine(tokens)) return;
    }
    if (type == TaskParser::LEFT_BRACE && depth == 0 && parse_block) {
      parse_block();
      continue;
    }
    if (type == TaskParser::LEFT_BRACE) ++depth;
    if (type == TaskParser::RIGHT_BRACE && depth > 0) --depth;
    parser.consume();
    // The lines below a lost declaration that are indented belong to it.
    const bool goes_on = !is_in_block && tokens.LT(1)->getCharPositionInLine() > 0 &&
                         tokens.LA(1) != antlr4::Token::EOF;
    if (depth == 0 && type == TaskParser::LINE_END && !goes_on) return;
  }
}

}  // namespace compiler
