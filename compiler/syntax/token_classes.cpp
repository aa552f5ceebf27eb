#include "compiler/syntax/token_classes.h"

#include <TaskLexer.h>
#include <TaskParser.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <initializer_list>

namespace compiler {
namespace {

using grammar::TaskLexer;
using grammar::TaskParser;

bool IsOneOf(TokenType type, std::initializer_list<TokenType> types) {
  return std::find(types.begin(), types.end(), type) != types.end();
}

// The grammar's tables, which every generated parser carries.
struct Tables {
  antlr4::ANTLRInputStream nothing{""};
  TaskLexer lexer{&nothing};
  antlr4::CommonTokenStream tokens{&lexer};
  TaskParser parser{&tokens};
};

TaskParser& Parser() {
  static Tables tables;
  return tables.parser;
}

// The tokens that a rule can begin with.
antlr4::misc::IntervalSet FirstOf(size_t rule) {
  const antlr4::atn::ATN& atn = Parser().getATN();
  return atn.nextTokens(atn.ruleToStartState[rule]);
}

const antlr4::misc::IntervalSet& Units() {
  static const antlr4::misc::IntervalSet units = FirstOf(TaskParser::RuleUnitName);
  return units;
}

std::vector<std::string> Spellings(const antlr4::misc::IntervalSet& set) {
  std::vector<std::string> spellings;
  for (const ssize_t type : set.toList()) {
    std::string spelling = Spelling(static_cast<TokenType>(type));
    if (!spelling.empty()) spellings.push_back(std::move(spelling));
  }
  return spellings;
}

}  // namespace

Span SpanOf(const antlr4::Token& token) {
  return {static_cast<uint32_t>(token.getStartIndex()),
          static_cast<uint32_t>(token.getStopIndex() + 1)};
}

bool IsComparison(TokenType type) {
  return IsOneOf(type, {TaskParser::LESS, TaskParser::LESS_EQUAL, TaskParser::GREATER,
                        TaskParser::GREATER_EQUAL, TaskParser::EQUAL, TaskParser::NOT_EQUAL});
}

bool IsAssignment(TokenType type) {
  return IsOneOf(type, {TaskParser::ASSIGN, TaskParser::ADD_ASSIGN, TaskParser::SUBTRACT_ASSIGN,
                        TaskParser::MULTIPLY_ASSIGN, TaskParser::DIVIDE_ASSIGN});
}

bool ExpectsOperand(TokenType type) {
  return IsComparison(type) || IsAssignment(type) ||
         IsOneOf(type, {TaskParser::PLUS, TaskParser::MINUS, TaskParser::TIMES, TaskParser::DIVIDE,
                        TaskParser::AND, TaskParser::OR, TaskParser::NOT, TaskParser::COMMA,
                        TaskParser::RANGE, TaskParser::ARROW, TaskParser::WITHIN});
}

bool FollowsOperand(TokenType type) {
  return (ExpectsOperand(type) && type != TaskParser::NOT) ||
         IsOneOf(type, {TaskParser::DOT, TaskParser::COLON, TaskParser::POWER,
                        TaskParser::LEFT_PARENTHESIS, TaskParser::LEFT_BRACKET});
}

bool EndsOperand(TokenType type) {
  return IsUnit(type) ||
         IsOneOf(type, {TaskParser::NAME, TaskParser::NUMBER, TaskParser::STRING, TaskParser::TRUE,
                        TaskParser::FALSE, TaskParser::REWARD, TaskParser::RIGHT_PARENTHESIS,
                        TaskParser::RIGHT_BRACKET, TaskParser::RIGHT_BRACE, TaskParser::SET_END});
}

bool StartsOperand(TokenType type) {
  return IsUnit(type) ||
         IsOneOf(type, {TaskParser::NAME, TaskParser::NUMBER, TaskParser::STRING, TaskParser::TRUE,
                        TaskParser::FALSE, TaskParser::REWARD, TaskParser::NOT});
}

bool IsDeclarationKeyword(TokenType type) {
  static const antlr4::misc::IntervalSet first = FirstOf(TaskParser::RuleDeclaration);
  // A `reward` mostly begins a statement.
  return type == TaskParser::TASK || type == TaskParser::ALLOW ||
         (first.contains(type) && type != TaskParser::REWARD);
}

bool IsStatementKeyword(TokenType type) {
  return IsOneOf(
      type, {TaskParser::LET, TaskParser::IF, TaskParser::ELSE, TaskParser::FOR, TaskParser::ONCE,
             TaskParser::END_EPISODE, TaskParser::TRUNCATE_EPISODE, TaskParser::LOG,
             TaskParser::REQUIRE, TaskParser::GIVEN, TaskParser::FIRE, TaskParser::EXPECT,
             TaskParser::RETURN, TaskParser::REDRAW, TaskParser::NEXT, TaskParser::ALLOW});
}

bool IsContextualKeyword(TokenType type) {
  return type >= TaskParser::FN && type <= TaskParser::RETURN;
}

bool IsUnit(TokenType type) { return Units().contains(type); }

bool IsReserved(TokenType type) {
  const std::string spelling = Spelling(type);
  return !spelling.empty() && std::isalpha(static_cast<unsigned char>(spelling.front())) != 0;
}

bool IsOpening(TokenType type) {
  return type == TaskParser::LEFT_PARENTHESIS || type == TaskParser::LEFT_BRACKET ||
         type == TaskParser::LEFT_BRACE;
}

bool IsClosing(TokenType type) {
  return type == TaskParser::RIGHT_PARENTHESIS || type == TaskParser::RIGHT_BRACKET ||
         type == TaskParser::RIGHT_BRACE;
}

std::string Spelling(TokenType type) {
  if (type == antlr4::Token::EOF) return "";
  const std::string quoted = Parser().getVocabulary().getLiteralName(type);
  return quoted.size() > 2 ? quoted.substr(1, quoted.size() - 2) : "";
}

std::string Quoted(TokenType type) { return fmt::format("`{}`", Spelling(type)); }

std::vector<std::string> DeclarationKeywords() {
  return Spellings(FirstOf(TaskParser::RuleDeclaration));
}

std::vector<std::string> StatementKeywords() {
  return Spellings(FirstOf(TaskParser::RuleStatement));
}

std::vector<std::string> UnitNames() { return Spellings(Units()); }

}  // namespace compiler
