// Parse tree to syntax tree: tests.
#pragma once

#include <TaskParser.h>

#include "compiler/syntax/allowances.h"
#include "compiler/syntax/expression_builder.h"
#include "compiler/syntax/statement_builder.h"
#include "compiler/syntax/syntax_report.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

class TestBuilder {
 public:
  // The builder of statements and the allowances must outlive it.
  TestBuilder(SyntaxReport& report, StatementBuilder& statements, Allowances& allowances)
      : report_(report), statements_(statements), allowances_(allowances), expressions_(report) {}

  // Without its documentation.
  TestDeclaration Build(grammar::TaskParser::TestContext& context);

 private:
  TestStatement BuildStatement(grammar::TaskParser::TestStatementContext& context);
  FireStatement Fire(grammar::TaskParser::FireContext& context);
  uint32_t Times(antlr4::Token& number);

  SyntaxReport& report_;
  StatementBuilder& statements_;
  Allowances& allowances_;
  ExpressionBuilder expressions_;
};

}  // namespace compiler
