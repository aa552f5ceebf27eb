#include "compiler/syntax/written_tokens.h"

#include <algorithm>

#include "compiler/syntax/file_parser.h"
#include "compiler/syntax/token_classes.h"
#include "compiler/syntax/tree_builder.h"

namespace compiler {
namespace {

using antlr4::ParserRuleContext;
using antlr4::tree::ParseTree;
using antlr4::tree::TerminalNode;
using grammar::TaskParser;

TokenRole RoleOfDivision(ParserRuleContext& unit_operator) {
  auto& unit = *static_cast<ParserRuleContext*>(unit_operator.parent);
  // `4 / s`: without a unit in front, the operator is the number's.
  const auto* first = dynamic_cast<TaskParser::UnitOperatorContext*>(unit.children.front());
  return first != nullptr ? TokenRole::kOperator : TokenRole::kUnitOperator;
}

TokenRole RoleOfBracket(const TerminalNode& node, const ParserRuleContext& parent) {
  const auto at = std::ranges::find(parent.children, static_cast<const ParseTree*>(&node));
  return dynamic_cast<TaskParser::UnitContext*>(*(at + 1)) != nullptr ? TokenRole::kUnitOpen
                                                                      : TokenRole::kIndexOpen;
}

TokenRole RoleOf(TerminalNode& node) {
  auto& parent = *static_cast<ParserRuleContext*>(node.parent);
  const size_t rule = parent.getRuleIndex();
  switch (node.getSymbol()->getType()) {
    case TaskParser::MINUS:
      return rule == TaskParser::RuleFactor || rule == TaskParser::RuleUnitFactor
                 ? TokenRole::kSign
                 : TokenRole::kOperator;
    case TaskParser::TIMES:
    case TaskParser::DIVIDE:
      return rule == TaskParser::RuleUnitOperator ? RoleOfDivision(parent) : TokenRole::kOperator;
    case TaskParser::RANGE:
      return rule == TaskParser::RuleItem ? TokenRole::kRange : TokenRole::kOperator;
    case TaskParser::POWER:
      return TokenRole::kPower;
    case TaskParser::DOT:
      return TokenRole::kDot;
    case TaskParser::COMMA:
      return TokenRole::kComma;
    case TaskParser::COLON:
      return TokenRole::kColon;
    case TaskParser::LEFT_PARENTHESIS:
      return rule == TaskParser::RulePrimary ? TokenRole::kGroupOpen : TokenRole::kCallOpen;
    case TaskParser::LEFT_BRACKET:
      return RoleOfBracket(node, parent);
    case TaskParser::SET_BEGIN:
      return TokenRole::kSetOpen;
    case TaskParser::RIGHT_PARENTHESIS:
    case TaskParser::RIGHT_BRACKET:
    case TaskParser::SET_END:
      return TokenRole::kBracketClose;
    case TaskParser::LEFT_BRACE:
      return TokenRole::kBlockOpen;
    case TaskParser::RIGHT_BRACE:
      return TokenRole::kBlockClose;
    default:
      break;
  }
  const bool is_any_unit = node.getSymbol()->getType() == TaskParser::ANY_UNIT;
  if (rule == TaskParser::RuleUnitName || is_any_unit) return TokenRole::kUnit;
  return IsReserved(node.getSymbol()->getType()) || EndsOperand(node.getSymbol()->getType())
             ? TokenRole::kWord
             : TokenRole::kOperator;
}

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
