// Reads the world that a task names.
#pragma once

#include <optional>

#include "compiler/source/diagnostic.h"
#include "compiler/source/file_reader.h"
#include "compiler/source/sources.h"
#include "compiler/syntax/syntax_tree.h"
#include "plugins/world/world_description.h"

namespace compiler {

// What is wrong with the world goes to `diagnostics`, at the place where its file says it. Its
// height map becomes one of the `sources`. Nothing where the tree names no world, or there is none.
std::optional<world::WorldDescription> FindWorld(SyntaxTree& tree, const FileReader& read,
                                                 Sources& sources, Diagnostics& diagnostics);

}  // namespace compiler
