// What may be written at a place.
#pragma once

#include "compiler/language_server/protocol.h"
#include "compiler/language_server/workspace.h"

namespace compiler {

// The protocol's list of completions.
protocol::Json Complete(const Document& document, uint32_t offset, Workspace& workspace);

}  // namespace compiler
