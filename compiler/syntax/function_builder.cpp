#include "compiler/syntax/function_builder.h"

#include <string>
#include <utility>

#include "compiler/syntax/lost_text.h"
#include "compiler/syntax/token_classes.h"
#include "compiler/syntax/unit_builder.h"

namespace compiler {

using grammar::TaskParser;

FunctionDeclaration FunctionBuilder::Build(TaskParser::FunctionContext& context) {
  FunctionDeclaration function;
  function.name = BuildName(*context.name());
  for (TaskParser::ParameterContext* parameter : context.parameter()) {
    TaskParser::TypeContext& type = *parameter->type();
    function.parameters.push_back({BuildName(*parameter->name()), BuildType(type),
                                   BuildUnitOf(type, UnitOwner::kFunction, report_)});
  }
  function.result = BuildType(*context.type());
  function.unit = BuildUnitOf(*context.type(), UnitOwner::kFunction, report_);
  if (context.body() != nullptr) {
    BuildBody(*context.body(), function);
  } else {
    function.value = expressions_.Build(*context.expression());
  }
  return function;
}

void FunctionBuilder::BuildBody(TaskParser::BodyContext& context, FunctionDeclaration& function) {
  bool is_faulty = false;  // the parser has found an error in a statement: perhaps the `return`
  bool has_result = false;
  function.value = {SpanOf(context), LostExpression{}};
  NoteLost(context, lost_);
  for (TaskParser::BodyStatementContext* statement : context.bodyStatement()) {
    if (has_result) {
      ReportBody(SpanOf(*statement->getStart()), "this comes after the `return`",
                 "`return` is the last statement of a function");
      return;
    }
    if (IsLost(*statement, report_)) {
      is_faulty = true;
      NoteLost(*statement, lost_);
    } else if (statement->let() != nullptr) {
      function.lets.push_back(statements_.Let(*statement->let()));
    } else {
      has_result = true;
      function.value = expressions_.Build(*statement->expression());
    }
  }
  if (has_result || is_faulty) return;
  ReportBody(SpanOf(*context.getStop()), "expected `return`, found `}`",
             "the last statement of a function returns its value: `return x`");
}

void FunctionBuilder::ReportBody(Span span, std::string message, std::string help) {
  Diagnostic diagnostic = MakeDiagnostic(code::kBadFunctionBody, span, std::move(message));
  diagnostic.help = std::move(help);
  report_.AddUnlessFaulty(std::move(diagnostic));
}

}  // namespace compiler
