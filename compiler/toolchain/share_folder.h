// The files that belong to taskc: share/taskc, beside the running program's bin folder.
#pragma once

#include <filesystem>
#include <string>

namespace compiler {

std::filesystem::path ShareFolder();

// `name`: a path inside that folder. Throws CallError where it cannot be read.
std::string ReadShareFile(const std::filesystem::path& name);

}  // namespace compiler
