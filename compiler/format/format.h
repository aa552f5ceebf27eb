// The layout of task files: `taskc fmt`.
#pragma once

#include <optional>
#include <string>

#include "compiler/source/diagnostic.h"
#include "compiler/source/source_file.h"

namespace compiler {

// A block that is written in one line stays there while it fits into this many columns.
inline constexpr uint32_t kLineWidth = 100;

// The text of a task in the one layout, which docs/language.md describes: the same tokens and the
// same comments in the same order. Lines that are too long are left to their author. Nothing if the
// file has syntax errors, which then go to `diagnostics`.
std::optional<std::string> Format(const SourceFile& source, Diagnostics& diagnostics);

}  // namespace compiler
