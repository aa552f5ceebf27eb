// Source text to syntax tree.
#pragma once

#include <cstdint>
#include <optional>

#include "compiler/source/diagnostic.h"
#include "compiler/source/source_file.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// How deeply brackets, blocks, `not` and `-` may be nested in a file, and how deep the tree of an
// expression may be. Later passes may rely on it where they call themselves.
inline constexpr uint32_t kMaxNesting = 200;

// Parses a file. All syntax errors go to `diagnostics`; what has one is left out of the tree and
// counted among what is lost, so that the rest can be checked. Nothing where the file cannot be
// parsed at all.
std::optional<SyntaxTree> Parse(const SourceFile& source, Diagnostics& diagnostics);

}  // namespace compiler
