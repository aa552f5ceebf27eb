#pragma once

#include <filesystem>

namespace runtime {

// The folder of the one run under `root` on which a trainer is running. Throws UserError where
// there is none, or more than one: then it names them.
std::filesystem::path FindTrainer(const std::filesystem::path& root);

}  // namespace runtime
