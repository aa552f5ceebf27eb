// What an editor offers to do about a mistake.
#pragma once

#include <string>

#include "compiler/language_server/protocol.h"

namespace compiler {

// The fixes of those diagnostics that touch a range. `diagnostics`: all that are published for the
// file `uri`; `params`: those of the request.
protocol::Json CodeActions(const protocol::Json& diagnostics, const std::string& uri,
                           const protocol::Json& params);

}  // namespace compiler
