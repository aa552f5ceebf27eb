#include "compiler/syntax/written_tokens.h"

#include "compiler/syntax/file_parser.h"
#include "compiler/syntax/token_classes.h"
#include "compiler/syntax/token_role.h"
#include "compiler/syntax/tree_builder.h"

namespace compiler {
namespace {

using antlr4::ParserRuleContext;
using antlr4::tree::ParseTree;
using antlr4::tree::TerminalNode;
using grammar::TaskParser;

bool BeginsLine(size_t rule) {
  return rule == TaskParser::RuleHeader || rule == TaskParser::RuleDeclaration ||
         rule == TaskParser::RuleAllow || rule == TaskParser::RuleStatement ||
         rule == TaskParser::RuleBodyStatement || rule == TaskParser::RuleTestStatement;
}

// Goes down the parse tree from left to right.
class Collector {
 public:
  explicit Collector(uint32_t first_offset) : first_offset_(first_offset) {}

  void Visit(ParserRuleContext& context) {
    begins_line_ = begins_line_ || BeginsLine(context.getRuleIndex());
    for (ParseTree* child : context.children) {
      if (auto* terminal = dynamic_cast<TerminalNode*>(child)) {
        Add(*terminal);
      } else {
        Visit(*static_cast<ParserRuleContext*>(child));
      }
    }
  }

  std::vector<WrittenToken> tokens;

 private:
  void Add(TerminalNode& node) {
    const TokenType type = node.getSymbol()->getType();
    if (type == TaskParser::LINE_END || type == antlr4::Token::EOF) return;
    const Span span = SpanOf(*node.getSymbol());
    tokens.push_back(
        {RoleOf(node), {span.begin - first_offset_, span.end - first_offset_}, begins_line_});
    begins_line_ = false;
  }

  const uint32_t first_offset_;  // of the file among its sources
  bool begins_line_ = false;
};

}  // namespace

std::optional<std::vector<WrittenToken>> ReadTokens(const SourceFile& source,
                                                    Diagnostics& diagnostics) {
  SyntaxReport report(source, diagnostics);
  FileParser parser(report);
  TaskParser::FileContext* file = parser.Parse();
  if (file == nullptr) return std::nullopt;
  BuildSyntaxTree(*file, parser.docs(), report);  // finds errors of its own
  if (report.has_errors()) return std::nullopt;
  Collector collector(source.first_offset());
  collector.Visit(*file);
  return std::move(collector.tokens);
}

}  // namespace compiler
