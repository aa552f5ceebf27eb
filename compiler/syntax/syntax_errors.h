// What ANTLR's parser does about an error: every message is one of ours, and one mistake costs one
// statement or declaration, not the rest of the file.
#pragma once

#include <antlr4-runtime.h>

#include <functional>
#include <set>

#include "compiler/syntax/syntax_report.h"
#include "compiler/syntax/token_classes.h"

namespace compiler {

// Errors leave the rules they occur in up to the statement or declaration, which is marked
// (`exception`) and skipped. So any other part of the parse tree is complete.
class SyntaxErrors : public antlr4::ANTLRErrorStrategy {
 public:
  explicit SyntaxErrors(SyntaxReport& report) : report_(report) {}

  void reset(antlr4::Parser*) override {}
  antlr4::Token* recoverInline(antlr4::Parser* parser) override;
  void recover(antlr4::Parser* parser, std::exception_ptr error) override;
  // Before each turn of the loops over statements and declarations.
  void sync(antlr4::Parser* parser) override;
  bool inErrorRecoveryMode(antlr4::Parser*) override { return is_recovering_; }
  void reportMatch(antlr4::Parser*) override { is_recovering_ = false; }
  void reportError(antlr4::Parser* parser, const antlr4::RecognitionException& error) override;

 private:
  void Report(antlr4::Parser& parser, antlr4::Token& found);
  // To the end of the statement or declaration, or before a word that must begin another. Errors in
  // its block, which `parse_block` would parse, are found nevertheless.
  using BlockParser = std::function<void()>;
  void Skip(antlr4::Parser& parser, bool is_in_block, const BlockParser& parse_block);

  SyntaxReport& report_;
  std::set<TokenType> refused_units_;  // that were to be names
  bool is_recovering_ = false;
};

}  // namespace compiler
