// Powers, which only units have.
#pragma once

#include <string>
#include <string_view>

#include "compiler/source/diagnostic.h"

namespace compiler {

// `x ^ 2`, `x ** 2`, `x²`: what to write instead. `sign`: what stands for the power, between the
// two operands; `exponent`: what it says itself, as `²` does.
Help HelpForPower(const SourceFile& source, Span sign, std::string_view exponent = "");

// `m/s2`: a unit with a digit. Empty if `name`, which stands in `span`, is not that.
Help HelpForPowerInName(const std::string& name, Span span);

}  // namespace compiler
