// Parse tree to syntax tree: functions.
#pragma once

#include <TaskParser.h>

#include "compiler/syntax/expression_builder.h"
#include "compiler/syntax/statement_builder.h"
#include "compiler/syntax/syntax_report.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

class FunctionBuilder {
 public:
  // The builder of statements must outlive it.
  FunctionBuilder(SyntaxReport& report, StatementBuilder& statements)
      : report_(report), statements_(statements), expressions_(report) {}

  // Without its documentation.
  FunctionDeclaration Build(grammar::TaskParser::FunctionContext& context);

 private:
  void BuildBody(grammar::TaskParser::BodyContext& context, FunctionDeclaration& function);
  void ReportBody(Span span, std::string message, std::string help);

  SyntaxReport& report_;
  StatementBuilder& statements_;
  ExpressionBuilder expressions_;
};

}  // namespace compiler
