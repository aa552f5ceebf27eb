#include "compiler/syntax/statement_builder.h"

#include <utility>
#include <vector>

#include "compiler/syntax/token_classes.h"
#include "compiler/syntax/unit_builder.h"
#include "compiler/syntax/word_lookup.h"

namespace compiler {
namespace {

using grammar::TaskParser;

AssignOperator AssignOperatorOf(TokenType type) {
  switch (type) {
    case TaskParser::ADD_ASSIGN:
      return AssignOperator::kAdd;
    case TaskParser::SUBTRACT_ASSIGN:
      return AssignOperator::kSubtract;
    case TaskParser::MULTIPLY_ASSIGN:
      return AssignOperator::kMultiply;
    case TaskParser::DIVIDE_ASSIGN:
      return AssignOperator::kDivide;
    default:
      return AssignOperator::kSet;
  }
}

}  // namespace

Block StatementBuilder::Build(TaskParser::BlockContext& context) {
  Block block;
  for (TaskParser::StatementContext* statement : context.statement()) {
    if (statement->exception == nullptr) block.push_back(BuildStatement(*statement));
  }
  return block;
}

Statement StatementBuilder::BuildStatement(TaskParser::StatementContext& context) {
  auto& inner = *static_cast<antlr4::ParserRuleContext*>(context.children.front());
  Statement statement{SpanOf(inner), {}};
  if (auto* let = context.let()) {
    statement.node = LetStatement{BuildName(*let->name()), expressions_.Build(*let->expression())};
  } else if (auto* assignment = context.assignment()) {
    statement.node = Assignment(*assignment);
  } else if (auto* branches = context.branches()) {
    statement.node = Branches(*branches);
  } else if (auto* reward = context.reward()) {
    statement.node = Reward(*reward);
  } else {
    statement.node = End(*context.end());
  }
  return statement;
}

AssignStatement StatementBuilder::Assignment(TaskParser::AssignmentContext& context) {
  const Identifier name = BuildName(*context.target);
  return {Target{name, std::nullopt, {}, name.span}, AssignOperatorOf(context.op->getType()),
          expressions_.Build(*context.expression())};
}

IfStatement StatementBuilder::Branches(TaskParser::BranchesContext& context) {
  IfStatement statement;
  const std::vector<TaskParser::ExpressionContext*> conditions = context.expression();
  const std::vector<TaskParser::BlockContext*> blocks = context.block();
  for (size_t i = 0; i < conditions.size(); ++i) {
    statement.branches.push_back({expressions_.Build(*conditions[i]), Build(*blocks[i])});
  }
  if (context.otherwise != nullptr) statement.otherwise = Build(*context.otherwise);
  return statement;
}

RewardStatement StatementBuilder::Reward(TaskParser::RewardContext& context) {
  RewardStatement statement;
  const auto doc = docs_.find(SpanOf(context).begin);
  if (doc != docs_.end()) statement.doc = doc->second;
  statement.is_rate = context.rate != nullptr;
  if (statement.is_rate) {
    constexpr std::array<Word<bool>, 1> kRate = {{{"rate", true}}};
    LookUp(BuildName(*context.rate), kRate, code::kUnknownWord, "a kind of reward", report_);
  }
  statement.name = BuildName(*context.name());
  statement.value = expressions_.Build(*context.expression());
  return statement;
}

EndStatement StatementBuilder::End(TaskParser::EndContext& context) {
  EndStatement statement{EndKind::kTruncated, "", {}};
  if (context.outcome != nullptr) {
    statement.kind = LookUp(BuildName(*context.outcome), kOutcomeNames, code::kUnknownWord,
                            "an outcome of an episode", report_);
  }
  antlr4::Token& text = *context.STRING()->getSymbol();
  statement.reason = Text(text);
  statement.reason_span = SpanOf(text);
  return statement;
}

// Without the quotes; `\"` and `\\` stand for the signs themselves.
std::string StatementBuilder::Text(antlr4::Token& token) {
  const Span span = SpanOf(token);
  const std::string& source = report_.source().text();
  std::string text;
  for (uint32_t i = span.begin + 1; i + 1 < span.end; ++i) {
    if (source[i] == '\\') {
      ++i;
      if (source[i] != '"' && source[i] != '\\') {
        Diagnostic diagnostic = MakeDiagnostic(code::kUnknownEscape, {i - 1, i + 1},
                                               "there is no such escape sequence");
        diagnostic.help = "a text knows `\\\"` and `\\\\`";
        report_.Add(std::move(diagnostic));
      }
    }
    text += source[i];
  }
  return text;
}

}  // namespace compiler
