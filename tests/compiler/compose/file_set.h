// Files that exist only in a test.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "compiler/compose/compose.h"

namespace compiler {

using FileSet = std::map<std::string, std::string>;

inline FileReader ReaderOf(FileSet files) {
  return [files = std::move(files)](const std::filesystem::path& file) {
    const auto found = files.find(file.string());
    return found != files.end() ? std::optional(found->second) : std::nullopt;
  };
}

// The file "main.task" with all that it needs.
struct Composed {
  explicit Composed(FileSet files) : read(ReaderOf(std::move(files))) {
    tree = Compose("main.task", read, sources, diagnostics);
  }

  std::string Messages() const { return Render(sources, diagnostics, false); }

  FileReader read;
  Sources sources;
  Diagnostics diagnostics;
  std::optional<SyntaxTree> tree;
};

}  // namespace compiler
