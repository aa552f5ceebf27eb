// The bounds of a term, a metric or a log as a person reads them.
#pragma once

#include <string>

#include "compiler/check/references.h"

namespace compiler {

// "between -4 and 0 each time"; empty where nothing bounds the value, and for other names.
std::string BoundsText(const Reference& reference, const CheckedTask& task);

}  // namespace compiler
