// How the compiler gets at the text of files.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace compiler {

// Reads a file's text: nothing if there is none. The editor's server answers with what is being
// edited.
using FileReader = std::function<std::optional<std::string>(const std::filesystem::path&)>;

// What is on the disk: at most a little more of a file than any file of a task may have.
std::optional<std::string> ReadFromDisk(const std::filesystem::path& file);
// The same; throws CallError naming the file and the reason where there is nothing to read.
std::string MustReadFromDisk(const std::filesystem::path& file);

}  // namespace compiler
