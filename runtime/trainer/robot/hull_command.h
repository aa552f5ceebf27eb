// trainer robot hull
#pragma once

#include "base/command_line/command.h"

namespace runtime {

void AddHullCommand(command_line::Command& robot);

}  // namespace runtime
