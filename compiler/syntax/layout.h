// Between the lexer and the parser: what the lines and brackets of a task mean.
#pragma once

#include <antlr4-runtime.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "compiler/syntax/syntax_report.h"
#include "compiler/syntax/token_classes.h"

namespace compiler {

struct TokenList {
  std::vector<std::unique_ptr<antlr4::Token>> tokens;
  std::map<uint32_t, std::string> docs;  // `///` lines by the offset of the token that follows them
  bool is_parseable = true;              // false: nested too deeply for the parser
};

// Makes the parser's tokens out of the lexer's: puts LINE_END where a line ends a statement, tells
// sets from blocks, reports and repairs wrong brackets and lexical errors.
class Layout {
 public:
  explicit Layout(SyntaxReport& report) : report_(report) {}

  TokenList Run(antlr4::Lexer& lexer);

 private:
  struct Bracket {
    TokenType type;
    Span span;
    bool is_block;              // a brace around statements rather than a set
    uint32_t nesting;           // what it adds to nesting_
    uint32_t indentation;       // of a block's line
    bool is_synthetic = false;  // its opening brace is missing
  };

  std::unique_ptr<antlr4::Token> NextToken(antlr4::Lexer& lexer);
  // `next`: the token that follows; null at the end.
  void Add(std::unique_ptr<antlr4::CommonToken> token, const antlr4::Token* next);
  void MendOperator(antlr4::CommonToken& token, const antlr4::Token* next);
  // Makes a name of a word that is not a keyword in its place.
  void ClassifyWord(antlr4::CommonToken& token, TokenType next);
  bool CanBeginStatement(const antlr4::CommonToken& token) const;
  bool IsBetweenOperands(TokenType next) const;
  bool IsInUnitOfType() const;
  void AddSynthetic(TokenType type);
  void AddDocumentation(const antlr4::Token& token);

  // Closes what is open around an expression that cannot continue with `next`.
  void EndExpression(const antlr4::CommonToken& next);

  // `next` is the first token of its line.
  void BeginLine(const antlr4::CommonToken& next);
  // Notes where a block must follow. Returns false if the token is to be left out: `if a:`.
  bool ExpectBlock(const antlr4::CommonToken& token, bool ends_line);
  // `within 3 s else reach`, between the name of a phase and its block.
  bool ContinuesPhase(TokenType type) const;
  void RejectForeignLoop(const antlr4::CommonToken& token);
  // Where `if`, `for`, `on` ... has no brace by the end of its line.
  void OpenMissingBlock();
  std::string MissingBlockHead() const;
  void RejectBrokenLine(const antlr4::CommonToken& next);

  void Open(antlr4::CommonToken& token);
  // Returns false if the token is to be left out.
  bool Close(antlr4::CommonToken& token, const antlr4::Token* next);
  bool IsOneTooMany(const antlr4::Token& next);
  void ReportUnmatched(const antlr4::CommonToken& token);
  bool IsInBrackets() const { return !open_.empty() && !open_.back().is_block; }
  // The next brace opens a set: `for l in {`, `for l in links - {`, `set supports = {`.
  bool IsSet() const;
  // The open brackets from `index` on are not closed: reports the innermost that has been opened,
  // before `next`, and closes them all.
  void CloseUnclosed(size_t index, const antlr4::CommonToken& next);
  void CloseMissingBlocks(const antlr4::CommonToken& closing);
  void ReportUnclosed(const Bracket& bracket, const antlr4::CommonToken& next);
  void Pop();

  void CountNesting(const antlr4::CommonToken& token);
  uint32_t IndentationOf(const antlr4::Token& token);  // of its line, in bytes

  SyntaxReport& report_;
  TokenList result_;
  std::vector<Bracket> open_;
  uint32_t nesting_ = 0;        // of open_
  uint32_t prefix_run_ = 0;     // signs and `not` in front of the next operand
  uint32_t measured_line_ = 0;  // whose indentation is known
  uint32_t indentation_ = 0;
  std::string doc_;            // the `///` lines since the last token
  size_t braceless_line_ = 0;  // a block without its opening brace stands in this line
  size_t allow_line_ = 0;      // its documentation is that of what follows
  // The word that says that a block must follow: `if`, `else`, `on` ...; `in` for a `for` that has
  // got that far. 0: none must.
  TokenType block_head_ = 0;
  bool is_in_set_ = false;  // in a declaration of a `set`
  const antlr4::Token* last_ = nullptr;
  std::vector<TokenType> synthetic_closings_;  // whose real ones may still come
  // Blocks whose closing brace stands further left than the line that opens them: where a brace is
  // missing in the end, it is probably theirs.
  std::vector<Bracket> suspects_;
};

}  // namespace compiler
