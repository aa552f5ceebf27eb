// Values as a person reads them.
#pragma once

#include <string>

#include "compiler/check/checked_task.h"
#include "compiler/check/value.h"

namespace compiler {

// "-4", "1.5 m/s", "true", "(0, 0, 1) m"; in SI units.
std::string ToString(const Value& value, const Type& type, const Unit& unit);

}  // namespace compiler
