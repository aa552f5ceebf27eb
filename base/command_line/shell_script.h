// What a shell runs to complete a program's command line.
#pragma once

#include <string>
#include <vector>

#include "base/command_line/command_tree.h"

namespace command_line {

std::string BashScript(const std::string& program, const std::vector<CommandEntry>& commands);
std::string ZshScript(const std::string& program, const std::vector<CommandEntry>& commands);
std::string FishScript(const std::string& program, const std::vector<CommandEntry>& commands);

// ---- What the scripts have in common ------------------------------------------------------------

// Each follows the words of the line from command to command in a variable, `command`, which is
// empty at first. These are the steps that there are: 'ctl module:add'.
std::vector<std::string> Steps(const std::vector<CommandEntry>& commands);

// The options that take a value, as in Steps(): 'train:--seed'.
std::vector<std::string> OptionsWithValue(const std::vector<CommandEntry>& commands);

std::vector<std::string> OptionNames(const CommandEntry& command);

// The command line that prints the names of a list, and nothing where that fails. `line`: what the
// shell reads as one word, with the words of the line so far.
std::string NamesCommand(const std::string& program, const std::string& list, const char* line);

std::string Joined(const std::vector<std::string>& words, const char* separator = " ");

}  // namespace command_line
