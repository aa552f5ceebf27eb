#include "compiler/driver/print_error.h"

#include <fmt/format.h>

#include <cstdio>

namespace compiler {

void PrintError(std::string_view message) { fmt::print(stderr, "taskc: {}\n", message); }

}  // namespace compiler
