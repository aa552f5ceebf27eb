// Parse tree to syntax tree: names, units and numbers.
#pragma once

#include <TaskParser.h>

#include "compiler/syntax/syntax_report.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

Span SpanOf(antlr4::ParserRuleContext& context);
Identifier BuildName(antlr4::Token& token);
Identifier BuildName(antlr4::ParserRuleContext& context);

UnitExpression BuildUnit(grammar::TaskParser::UnitContext& context, SyntaxReport& report);
NumberLiteral BuildNumber(grammar::TaskParser::NumberContext& context, SyntaxReport& report);

}  // namespace compiler
