// Which lines of C++ a line of the task has become, for reading them side by side.
#pragma once

#include <string>
#include <vector>

#include "compiler/emit/text_writer.h"

namespace compiler {

// Two columns, a line for each line of the task that has become C++, by file and number:
//
//   crawling.task:15  103-104, 131
//   crawling.task:16  105
std::string LineMap(const std::vector<LineOrigin>& origins);

}  // namespace compiler
