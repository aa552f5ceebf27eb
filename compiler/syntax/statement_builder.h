// Parse tree to syntax tree: statements.
#pragma once

#include <TaskParser.h>

#include <map>
#include <string>

#include "compiler/syntax/expression_builder.h"
#include "compiler/syntax/syntax_report.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

class StatementBuilder {
 public:
  // `docs`: the documentation by the offset of what it describes; must outlive the builder.
  StatementBuilder(SyntaxReport& report, const std::map<uint32_t, std::string>& docs)
      : report_(report), docs_(docs), expressions_(report) {}

  // Statements in which the parser has found an error are left out.
  Block Build(grammar::TaskParser::BlockContext& context);

 private:
  Statement BuildStatement(grammar::TaskParser::StatementContext& context);
  AssignStatement Assignment(grammar::TaskParser::AssignmentContext& context);
  IfStatement Branches(grammar::TaskParser::BranchesContext& context);
  RewardStatement Reward(grammar::TaskParser::RewardContext& context);
  EndStatement End(grammar::TaskParser::EndContext& context);
  std::string Text(antlr4::Token& token);

  SyntaxReport& report_;
  const std::map<uint32_t, std::string>& docs_;
  ExpressionBuilder expressions_;
};

}  // namespace compiler
