#include "compiler/syntax/parse.h"

#include "compiler/syntax/file_parser.h"
#include "compiler/syntax/syntax_report.h"
#include "compiler/syntax/tree_builder.h"

namespace compiler {

std::optional<SyntaxTree> Parse(const SourceFile& source, Diagnostics& diagnostics) {
  SyntaxReport report(source, diagnostics);
  FileParser parser(report);
  grammar::TaskParser::FileContext* file = parser.Parse();
  if (file == nullptr) return std::nullopt;
  return BuildSyntaxTree(*file, parser.docs(), report);
}

}  // namespace compiler
