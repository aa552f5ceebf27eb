// Files that exist only in a test.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
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

// Files in one text, each behind a line `==== NAME`.
inline FileSet SplitFiles(const std::string& text) {
  constexpr std::string_view kHeading = "==== ";
  FileSet files;
  std::string* file = nullptr;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(kHeading)) {
      file = &files[line.substr(kHeading.size())];
    } else if (file != nullptr) {
      *file += line + "\n";
    }
  }
  return files;
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
