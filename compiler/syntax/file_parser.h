// The parser as ANTLR generates it, run on one file.
#pragma once

#include <TaskParser.h>

#include <map>
#include <memory>
#include <string>

#include "compiler/syntax/byte_stream.h"
#include "compiler/syntax/quick_lexer.h"
#include "compiler/syntax/syntax_report.h"

namespace compiler {

// Owns the parse tree and all that it points to.
class FileParser {
 public:
  explicit FileParser(SyntaxReport& report);

  // The parse tree, with errors in it where the report has some; null where the file is too large
  // or nested too deeply to be parsed.
  grammar::TaskParser::FileContext* Parse();
  // `///` lines by the offset of the token that follows them.
  const std::map<uint32_t, std::string>& docs() const { return docs_; }

 private:
  grammar::TaskParser::FileContext* ParseTokens();

  SyntaxReport& report_;
  ByteStream bytes_;
  QuickLexer lexer_;
  std::map<uint32_t, std::string> docs_;
  std::unique_ptr<antlr4::ListTokenSource> source_;
  std::unique_ptr<antlr4::CommonTokenStream> tokens_;
  std::unique_ptr<grammar::TaskParser> parser_;
};

}  // namespace compiler
