// What a file declares, for the editor's outline.
#pragma once

#include "compiler/language_server/document.h"
#include "compiler/language_server/protocol.h"

namespace compiler {

protocol::Json DocumentSymbols(const Document& document);

}  // namespace compiler
