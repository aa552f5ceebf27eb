// Parse tree to syntax tree: the file and its declarations.
#pragma once

#include <TaskParser.h>

#include "compiler/syntax/layout.h"
#include "compiler/syntax/syntax_report.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Of declarations and statements in which the parser has found an error there is only what stands
// in their blocks; `lost` of the tree says what else they may be. Such a tree is only good for
// finding more errors.
SyntaxTree BuildSyntaxTree(grammar::TaskParser::FileContext& file,
                           const std::map<uint32_t, std::string>& docs, SyntaxReport& report);

}  // namespace compiler
