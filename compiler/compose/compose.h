// A task's file, those that it imports and extends, and its tables, to one syntax tree.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "compiler/source/diagnostic.h"
#include "compiler/source/file_reader.h"
#include "compiler/source/sources.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// What a task may consist of.
inline constexpr size_t kMaxFiles = 100;
inline constexpr size_t kMaxTotalSize = 10'000'000;  // bytes
inline constexpr size_t kMaxChain = 20;  // files of which each imports or extends the next

// Parses `file`, all that it imports and extends, and the tables that are left then into `sources`;
// merges them into one tree, without imports, overrides and a base. The declarations of the base
// come first; its events hold the blocks that were appended to them. With errors, what could not be
// read is among what the tree has lost. Nothing where `file` cannot be parsed at all. Throws
// CallError where it cannot be read.
std::optional<SyntaxTree> Compose(const std::filesystem::path& file, const FileReader& read,
                                  Sources& sources, Diagnostics& diagnostics);

}  // namespace compiler
