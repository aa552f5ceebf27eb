#pragma once

#include "compiler/analyze/analyze.h"
#include "compiler/language_server/protocol.h"

namespace compiler {

// The page that `taskc doc` writes, as data (docs/editors.md); null where the text has errors.
protocol::Json PageOfTask(const Analysis& analysis);

}  // namespace compiler
