#include "compiler/syntax/token_role.h"

#include <TaskParser.h>

#include <algorithm>

#include "compiler/syntax/token_classes.h"

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

}  // namespace

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

}  // namespace compiler
