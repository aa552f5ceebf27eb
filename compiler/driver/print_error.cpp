#include "compiler/driver/print_error.h"

#include <fmt/format.h>

#include <cstdio>

#include "base/text/print.h"

namespace compiler {

void PrintError(std::string_view message) { text::Print(stderr, "taskc: {}\n", message); }

}  // namespace compiler
