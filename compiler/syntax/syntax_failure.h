// A place at which the parser cannot continue, and the words to describe it with.
#pragma once

#include <antlr4-runtime.h>

#include <string>

#include "compiler/source/diagnostic.h"
#include "compiler/syntax/token_classes.h"

namespace compiler {

struct Failure {
  antlr4::Parser& parser;
  const SourceFile& file;
  const antlr4::Token& found;        // the token that does not fit
  const antlr4::Token* before_last;  // the two tokens before it and the one after it, or null
  const antlr4::Token* last;
  const antlr4::Token* next;
  const antlr4::Token* begin;  // the first of the rule that fails, and the one before that
  const antlr4::Token* before_begin;
  const antlr4::Token* statement;  // the first token of the statement or declaration, or null
  size_t rule;                     // the grammar's rule that fails, and the one it is part of
  size_t parent_rule;

  TokenType type() const { return found.getType(); }
  TokenType last_type() const { return last != nullptr ? last->getType() : 0; }
  TokenType next_type() const { return next != nullptr ? next->getType() : 0; }
  TokenType statement_type() const { return statement != nullptr ? statement->getType() : 0; }
  bool expects(TokenType type) const { return parser.getExpectedTokens().contains(type); }
  bool is_at_line_start() const;
  // Nothing visible stands there, or what stands there is in a later line than the mistake.
  bool is_behind_last() const;
};

// `parser` stands in the rule that failed.
Failure MakeFailure(antlr4::Parser& parser, antlr4::Token& found, const SourceFile& file);

// "`let`", "a string", "the end of the line"
std::string FoundText(const Failure& failure);

// The empty span after the last token.
Span PlaceBehindLast(const Failure& failure);

// "expected {what}, found ...", at the found token or, if that is after the mistake, after the
// last.
Diagnostic Expected(const Failure& failure, const std::string& what);
// The same after the last token in any case: where a symbol is missing.
Diagnostic ExpectedBehindLast(const Failure& failure, const std::string& what);

Diagnostic WithHelp(Diagnostic diagnostic, Help help);

}  // namespace compiler
