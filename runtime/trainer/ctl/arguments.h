#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "base/command_line/command.h"
#include "runtime/live/control/command_table.h"

namespace runtime {

// Declares how the arguments of a command are written on the command line: as the command table
// says, or, for a few commands, in a shorter way. Fills `arguments`, an object, while the line is
// parsed; it must live until then.
void AddCtlArguments(command_line::Command& command, const CommandSpec& spec,
                     nlohmann::json& arguments);

// How `trainer ctl` calls a command, "module add", and a required argument of it, "NAME".
std::string CtlWords(const CommandSpec& spec);
std::string CtlWord(const ArgumentSpec& spec);

}  // namespace runtime
