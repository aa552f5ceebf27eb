// trainer robot import
#pragma once

#include "base/command_line/command.h"

namespace runtime {

void AddImportRobotCommand(command_line::Command& robot);

}  // namespace runtime
