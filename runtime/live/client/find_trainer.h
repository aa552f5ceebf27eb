#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace runtime {

// The folders of all runs under `root` on which a trainer is running, in alphabetical order.
std::vector<std::string> TrainersUnder(const std::filesystem::path& root);

// The folder of the one run under `root` on which a trainer is running. Throws UserError where
// there is none, or more than one: then it names them.
std::filesystem::path FindTrainer(const std::filesystem::path& root);

}  // namespace runtime
