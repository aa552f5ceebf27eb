#include "compiler/syntax/lost_text.h"

#include <algorithm>
#include <string>

#include "compiler/syntax/token_classes.h"

namespace compiler {
namespace {

using antlr4::ParserRuleContext;
using antlr4::tree::ParseTree;
using antlr4::tree::TerminalNode;
using grammar::TaskParser;

// What is read for itself inside a statement, a declaration, a block or the file.
bool IsReadForItself(const ParserRuleContext& context) {
  switch (context.getRuleIndex()) {
    case TaskParser::RuleAllow:
    case TaskParser::RuleHeader:
    case TaskParser::RuleDeclaration:
    case TaskParser::RuleBlock:
    case TaskParser::RuleStatement:
    case TaskParser::RuleBody:
    case TaskParser::RuleBodyStatement:
    case TaskParser::RuleTestBlock:
    case TaskParser::RuleTestStatement:
      return true;
    default:
      return false;
  }
}

// What a block or the file consists of beside its statements or declarations.
bool IsFrame(TokenType type) {
  return type == TaskParser::LINE_END || type == TaskParser::LEFT_BRACE ||
         type == TaskParser::RIGHT_BRACE || type == antlr4::Token::EOF;
}

// What comes behind the name of a declaration.
bool EndsHead(TokenType type) {
  return IsAssignment(type) || type == TaskParser::COLON || type == TaskParser::LEFT_PARENTHESIS;
}

bool DeclaresName(TokenType type) {
  switch (type) {
    case TaskParser::SENSOR:
    case TaskParser::PARAM:
    case TaskParser::MEMORY:
    case TaskParser::GOAL:
    case TaskParser::PHASE:
    case TaskParser::TABLE:
    case TaskParser::METRIC:
    case TaskParser::FN:
    case TaskParser::LET:
    case TaskParser::REWARD:
    case TaskParser::LOG:
    case TaskParser::FOR:
      return true;
    default:
      return false;
  }
}

// The closing one may be missing.
std::string WithoutQuotes(const std::string& text) {
  const size_t end = text.size() > 1 && text.ends_with('"') ? text.size() - 1 : text.size();
  return text.substr(1, end - 1);
}

// Calls `visit` for the tokens of `context` itself.
template <typename Visit>
void ForEachToken(ParserRuleContext& context, const Visit& visit) {
  for (ParseTree* child : context.children) {
    if (auto* terminal = dynamic_cast<TerminalNode*>(child)) {
      visit(*terminal->getSymbol());
    } else if (auto* part = dynamic_cast<ParserRuleContext*>(child)) {
      if (!IsReadForItself(*part)) ForEachToken(*part, visit);
    }
  }
}

}  // namespace

bool IsLost(ParserRuleContext& context, const SyntaxReport& report) {
  if (context.exception != nullptr) return true;
  if (!report.has_errors()) return false;
  bool is_lost = false;
  ForEachToken(context, [&](const antlr4::Token& token) {
    is_lost =
        is_lost || (token.getType() != TaskParser::LINE_END && report.IsFaulty(SpanOf(token)));
  });
  return is_lost;
}

std::vector<TaskParser::BlockContext*> BlocksIn(ParserRuleContext& context) {
  std::vector<TaskParser::BlockContext*> blocks;
  for (ParseTree* child : context.children) {
    if (auto* block = dynamic_cast<TaskParser::BlockContext*>(child)) {
      blocks.push_back(block);
    } else if (auto* part = dynamic_cast<ParserRuleContext*>(child)) {
      std::ranges::copy(BlocksIn(*part), std::back_inserter(blocks));
    }
  }
  return blocks;
}

void NoteLost(ParserRuleContext& context, LostText& lost) {
  bool declares = false;
  bool has_name = false;
  bool has_text = false;
  bool ends_episode = false;
  bool is_behind_head = false;
  ForEachToken(context, [&](const antlr4::Token& token) {
    const TokenType type = token.getType();
    const bool begins_statement = IsStatementKeyword(type) || IsDeclarationKeyword(type) ||
                                  type == TaskParser::REWARD || type == TaskParser::LINE_END;
    if (begins_statement) is_behind_head = false;
    lost.has_code = lost.has_code || !IsFrame(type);
    is_behind_head = is_behind_head || EndsHead(type);
    declares = declares || DeclaresName(type);
    if (type == TaskParser::NAME && !is_behind_head) {
      lost.words.insert(token.getText());
      has_name = true;
    }
    ends_episode =
        ends_episode || type == TaskParser::END_EPISODE || type == TaskParser::TRUNCATE_EPISODE;
    if (type == TaskParser::STRING) {
      lost.words.insert(WithoutQuotes(token.getText()));
      has_text = true;
    }
  });
  const bool is_nameless = (declares && !has_name) || (ends_episode && !has_text);
  lost.has_anything = lost.has_anything || is_nameless;
}

}  // namespace compiler
