// What is wrong with the open files, in the protocol's form.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "compiler/language_server/protocol.h"
#include "compiler/language_server/workspace.h"

namespace compiler {

// The diagnostics of one task, by the file in which they are; the task's own file is always there.
// Those that can be mended by an edit have `data.fixes`, from which CodeActions() makes its answer.
// `page`: the file that explains the codes; empty where there is none.
std::map<std::string, protocol::Json> DiagnosticsByUri(const Findings& findings,
                                                       const std::filesystem::path& page,
                                                       PositionEncoding encoding);

}  // namespace compiler
