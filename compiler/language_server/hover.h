// What is known of the word at a place.
#pragma once

#include "compiler/language_server/protocol.h"
#include "compiler/language_server/workspace.h"

namespace compiler {

// The protocol's hover, or null.
protocol::Json Hover(const Document& document, uint32_t offset, Workspace& workspace);

// The name and signature of a function as they are shown: "clamp(x, low, high)"; empty where there
// is no such function. A function with several forms has one in each line.
std::string SignatureOf(std::string_view function, const Document& document, Workspace& workspace);

}  // namespace compiler
