// Syntax trees cannot be copied by accident; here it is done on purpose.
#pragma once

#include "compiler/syntax/syntax_tree.h"

namespace compiler {

Expression CopyOf(const Expression& expression);

}  // namespace compiler
