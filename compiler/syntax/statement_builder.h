// Parse tree to syntax tree: statements.
#pragma once

#include <TaskParser.h>

#include <map>
#include <string>

#include "compiler/syntax/allowances.h"
#include "compiler/syntax/expression_builder.h"
#include "compiler/syntax/syntax_report.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

class StatementBuilder {
 public:
  // `docs`: the documentation by the offset of what it describes. What is left out goes to `lost`.
  // All must outlive the builder.
  StatementBuilder(SyntaxReport& report, const std::map<uint32_t, std::string>& docs,
                   Allowances& allowances, LostText& lost)
      : report_(report), docs_(docs), allowances_(allowances), lost_(lost), expressions_(report) {}

  // Of statements in which the parser has found an error there is what stands in their blocks.
  Block Build(grammar::TaskParser::BlockContext& context);
  LetStatement Let(grammar::TaskParser::LetContext& context);
  // The kind is one of all; Reward() does not ask whether it may stand here.
  RewardKind KindOf(grammar::TaskParser::RewardContext& context);
  RewardStatement Reward(grammar::TaskParser::RewardContext& context, RewardKind kind);
  EndStatement End(grammar::TaskParser::EndContext& context);
  Target BuildTarget(grammar::TaskParser::TargetContext& context);

 private:
  void AddLost(grammar::TaskParser::StatementContext& context, Block& block);
  Statement BuildStatement(grammar::TaskParser::StatementContext& context);
  AssignStatement Assignment(grammar::TaskParser::AssignmentContext& context);
  RewardStatement RewardInBlock(grammar::TaskParser::RewardContext& context);
  IfStatement Branches(grammar::TaskParser::BranchesContext& context);
  ForStatement Loop(grammar::TaskParser::LoopContext& context);
  OnceStatement Once(grammar::TaskParser::OnceContext& context);
  LogStatement Log(grammar::TaskParser::LogContext& context);
  RequireStatement Require(grammar::TaskParser::RequireContext& context);
  std::string DocOf(antlr4::ParserRuleContext& context) const;

  SyntaxReport& report_;
  const std::map<uint32_t, std::string>& docs_;
  Allowances& allowances_;
  LostText& lost_;
  ExpressionBuilder expressions_;
};

}  // namespace compiler
