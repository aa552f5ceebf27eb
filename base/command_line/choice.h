#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace command_line {

// An option whose value is one of a few words.
CLI::Option* AddChoice(CLI::App& app, const std::string& option, std::string& value,
                       const std::vector<std::string>& words, const std::string& description);

}  // namespace command_line
