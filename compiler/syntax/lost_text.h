// The parts of a file in which the parser has found an error.
#pragma once

#include <TaskParser.h>

#include <vector>

#include "compiler/syntax/syntax_report.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Is there an error in a statement, a declaration or the header? What stands in blocks inside it
// does not count: that is read for itself.
bool IsLost(antlr4::ParserRuleContext& context, const SyntaxReport& report);

// The outermost blocks in `context`.
std::vector<grammar::TaskParser::BlockContext*> BlocksIn(antlr4::ParserRuleContext& context);

// Notes what a lost part may have declared, without what stands in its blocks; `context` may also
// be a block or the file, of which that is noted which belongs to no statement or declaration.
void NoteLost(antlr4::ParserRuleContext& context, LostText& lost);

}  // namespace compiler
