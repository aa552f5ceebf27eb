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
  // The builder of statements must outlive it, and so must `lost`, where that goes which is left
  // out.
  FunctionBuilder(SyntaxReport& report, StatementBuilder& statements, LostText& lost)
      : report_(report), statements_(statements), lost_(lost), expressions_(report) {}

  // Without its documentation.
  FunctionDeclaration Build(grammar::TaskParser::FunctionContext& context);

 private:
  void BuildBody(grammar::TaskParser::BodyContext& context, FunctionDeclaration& function);
  void ReportBody(Span span, std::string message, std::string help);

  SyntaxReport& report_;
  StatementBuilder& statements_;
  LostText& lost_;
  ExpressionBuilder expressions_;
};

}  // namespace compiler
