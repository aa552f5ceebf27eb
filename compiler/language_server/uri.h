// Files as editors name them: "file:///tasks/crawling.task".
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace compiler {

// The path of a `file:` address; nothing for any other.
std::optional<std::filesystem::path> PathOfUri(std::string_view uri);

// The address of a file; relative paths start from the current folder.
std::string UriOfPath(const std::filesystem::path& path);

}  // namespace compiler
