// Where names are declared and used, in this file and in those that are made with it.
#pragma once

#include <string>

#include "compiler/language_server/protocol.h"
#include "compiler/language_server/workspace.h"

namespace compiler {

// The place of the declaration, or null.
protocol::Json Definition(const Document& document, uint32_t offset, Workspace& workspace);

// All places; without that of the declaration where it is not wanted.
protocol::Json FindReferences(const Document& document, uint32_t offset, bool with_declaration,
                              Workspace& workspace);

// The uses in this file.
protocol::Json Highlights(const Document& document, uint32_t offset, Workspace& workspace);

// The range of a name that can be renamed, or null.
protocol::Json PrepareRename(const Document& document, uint32_t offset, Workspace& workspace);

struct RenameResult {
  protocol::Json edit;  // null where it was refused
  std::string refusal;
};
// Refused where the new name would make an error out of any file that is made with this one.
RenameResult Rename(const Document& document, uint32_t offset, const std::string& name,
                    Workspace& workspace);

}  // namespace compiler
