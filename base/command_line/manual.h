// The manual pages of a program, written from the declarations of its command line: what `--help`
// says, for `man`.
#pragma once

#include <map>
#include <string>

#include "base/command_line/command.h"

namespace command_line {

// A page for the program and one for each of its commands, by their files: "trainer-ctl-swap.1".
// `version`: "trainer 1.0"; `related`: another program that has pages.
std::map<std::string, std::string> ManualPages(const Command& program, const std::string& version,
                                               const std::string& related);

// Adds the command `manual FOLDER`, which writes these pages. It is hidden: what builds the program
// calls it.
void AddManual(Command& program, const std::string& version, const std::string& related);

}  // namespace command_line
