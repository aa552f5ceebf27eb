#pragma once

#include "compiler/analyze/analyze.h"
#include "compiler/language_server/protocol.h"

namespace compiler {

// What the lets of the text are worth where the numbers are `known`: {"base.up.z": [1]}
// (docs/editors.md); null where the text has errors. Throws where `known` is no such object.
protocol::Json WorthOfLets(const Analysis& analysis, const protocol::Json& known);

}  // namespace compiler
