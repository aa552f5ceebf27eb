// The call that is being written, and its current argument.
#pragma once

#include "compiler/language_server/protocol.h"
#include "compiler/language_server/workspace.h"

namespace compiler {

// The protocol's signature help, or null.
protocol::Json SignatureHelp(const Document& document, uint32_t offset, Workspace& workspace);

}  // namespace compiler
