// Parse tree to syntax tree: names, texts, types, units and numbers.
#pragma once

#include <TaskParser.h>

#include <optional>
#include <string>

#include "compiler/syntax/syntax_report.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

Span SpanOf(antlr4::ParserRuleContext& context);
Identifier BuildName(antlr4::Token& token);
Identifier BuildName(antlr4::ParserRuleContext& context);
// A text without its quotes; `\"` and `\\` stand for the signs themselves.
std::string BuildText(antlr4::Token& token, SyntaxReport& report);
// One that must not be empty; `need` says so.
std::string BuildNeededText(antlr4::Token& token, const char* need, SyntaxReport& report);

TypeExpression BuildType(grammar::TaskParser::TypeContext& context);
// The unit after a type, of a declaration or of a function's parameter or result.
enum class UnitOwner { kDeclaration, kFunction };
std::optional<UnitExpression> BuildUnitOf(grammar::TaskParser::TypeContext& context,
                                          UnitOwner owner, SyntaxReport& report);
UnitExpression BuildUnit(grammar::TaskParser::UnitContext& context, SyntaxReport& report);
// Nothing, after a message, where the number cannot be represented.
std::optional<NumberLiteral> BuildNumber(grammar::TaskParser::NumberContext& context,
                                         SyntaxReport& report);

}  // namespace compiler
