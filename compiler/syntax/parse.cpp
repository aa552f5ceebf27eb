#include "compiler/syntax/parse.h"

#include <TaskLexer.h>
#include <TaskParser.h>
#include <fmt/format.h>

#include <memory>
#include <string>
#include <utility>

#include "compiler/syntax/byte_stream.h"
#include "compiler/syntax/layout.h"
#include "compiler/syntax/lexical_errors.h"
#include "compiler/syntax/syntax_errors.h"
#include "compiler/syntax/syntax_report.h"
#include "compiler/syntax/tree_builder.h"

namespace compiler {
namespace {

using grammar::TaskLexer;
using grammar::TaskParser;

bool IsTooLarge(SyntaxReport& report) {
  if (report.source().text().size() <= SourceFile::kMaxSize) return false;
  Diagnostic diagnostic =
      MakeDiagnostic(code::kFileTooLarge, {0, 0},
                     fmt::format("the file is larger than {} bytes", SourceFile::kMaxSize));
  diagnostic.help = "is it a task? the largest tasks have a few kilobytes";
  report.Add(std::move(diagnostic));
  return true;
}

// Two attempts: the fast one gives up at the first sign of an error, which the thorough one then
// either explains or finds to be none.
TaskParser::FileContext* ParseTokens(antlr4::CommonTokenStream& tokens, TaskParser& parser,
                                     SyntaxReport& report) {
  auto& simulator = *parser.getInterpreter<antlr4::atn::ParserATNSimulator>();
  parser.removeErrorListeners();
  if (!report.has_errors()) {
    simulator.setPredictionMode(antlr4::atn::PredictionMode::SLL);
    parser.setErrorHandler(std::make_shared<antlr4::BailErrorStrategy>());
    try {
      return parser.file();
    } catch (const antlr4::ParseCancellationException&) {
      tokens.seek(0);
      parser.reset();
    }
  }
  tokens.fill();  // the messages look ahead
  simulator.setPredictionMode(antlr4::atn::PredictionMode::LL);
  parser.setErrorHandler(std::make_shared<SyntaxErrors>(report));
  return parser.file();
}

}  // namespace

std::optional<SyntaxTree> Parse(const SourceFile& source, Diagnostics& diagnostics) {
  SyntaxReport report(source, diagnostics);
  if (IsTooLarge(report)) return std::nullopt;
  CheckUtf8(report);
  ByteStream bytes(source.text());
  TaskLexer lexer(&bytes);
  lexer.removeErrorListeners();
  TokenList list = Layout(report).Run(lexer);
  if (!list.is_parseable) return std::nullopt;
  antlr4::ListTokenSource token_source(std::move(list.tokens));
  antlr4::CommonTokenStream tokens(&token_source);
  TaskParser parser(&tokens);
  TaskParser::FileContext* file = ParseTokens(tokens, parser, report);
  SyntaxTree tree = BuildSyntaxTree(*file, list.docs, report);
  if (report.has_errors()) return std::nullopt;
  return tree;
}

}  // namespace compiler
