#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/live/control/command.h"

namespace runtime {

// The names of these parts in the run of this folder. Throws UserError where no trainer answers.
std::vector<std::string> KnownNames(const std::filesystem::path& run, NamedPart part);

}  // namespace runtime
