#include "compiler/syntax/file_parser.h"

#include <fmt/format.h>

#include <utility>

#include "compiler/syntax/characters.h"
#include "compiler/syntax/layout.h"
#include "compiler/syntax/syntax_errors.h"

namespace compiler {
namespace {

using grammar::TaskParser;

bool IsTooLarge(SyntaxReport& report) {
  if (report.source().text().size() <= SourceFile::kMaxSize) return false;
  const uint32_t begin = report.source().first_offset();
  Diagnostic diagnostic =
      MakeDiagnostic(code::kFileTooLarge, {begin, begin},
                     fmt::format("the file is larger than {} bytes", SourceFile::kMaxSize));
  diagnostic.help = "is it a task? the largest tasks have a few kilobytes";
  report.Add(std::move(diagnostic));
  return true;
}

}  // namespace

FileParser::FileParser(SyntaxReport& report)
    : report_(report), bytes_(report.source()), lexer_(&bytes_) {
  lexer_.removeErrorListeners();
}

TaskParser::FileContext* FileParser::Parse() {
  if (IsTooLarge(report_) || IsInOtherEncoding(report_)) return nullptr;
  CheckCharacters(report_);
  TokenList list = Layout(report_).Run(lexer_);
  if (!list.is_parseable) return nullptr;
  docs_ = std::move(list.docs);
  source_ = std::make_unique<antlr4::ListTokenSource>(std::move(list.tokens));
  tokens_ = std::make_unique<antlr4::CommonTokenStream>(source_.get());
  parser_ = std::make_unique<TaskParser>(tokens_.get());
  return ParseTokens();
}

// Two attempts: the fast one gives up at the first sign of an error, which the thorough one then
// either explains or finds to be none.
TaskParser::FileContext* FileParser::ParseTokens() {
  auto& simulator = *parser_->getInterpreter<antlr4::atn::ParserATNSimulator>();
  parser_->removeErrorListeners();
  if (!report_.has_errors()) {
    simulator.setPredictionMode(antlr4::atn::PredictionMode::SLL);
    parser_->setErrorHandler(std::make_shared<antlr4::BailErrorStrategy>());
    try {
      return parser_->file();
    } catch (const antlr4::ParseCancellationException&) {
      tokens_->seek(0);
      parser_->reset();
    }
  }
  tokens_->fill();  // the messages look ahead
  simulator.setPredictionMode(antlr4::atn::PredictionMode::LL);
  parser_->setErrorHandler(std::make_shared<SyntaxErrors>(report_));
  return parser_->file();
}

}  // namespace compiler
