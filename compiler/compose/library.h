// Libraries that a task imports by name: `import "std/gait"`.
//
// A path with an extension is that of a file, beside the one that imports it. A path without one is
// the name of a library, wherever the task lies: NAME.task in one of the folders where libraries
// are. So a folder `std` beside a task hides nothing, and is hidden by nothing.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace compiler {

bool IsLibraryName(std::string_view path);

// The file that an import in `importer` names, whether it exists or not.
std::filesystem::path ImportedFile(const std::filesystem::path& importer, std::string_view path);

// Where libraries are searched for: the folders of the environment variable TASKC_LIBRARY_PATH
// (separated by ':'), then share/taskc/library beside the running program's bin folder.
std::vector<std::filesystem::path> LibraryFolders();

// Does the file lie in one of them?
bool IsOfLibrary(const std::filesystem::path& file);

// All that can be imported by name, in the order of the alphabet.
std::vector<std::string> LibraryNames();

}  // namespace compiler
