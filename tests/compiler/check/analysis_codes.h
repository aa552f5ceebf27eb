// Which diagnostics are not the checker's, but come from allowances, bounds, phases, starts and
// observations.
#pragma once

#include <string_view>

#include "compiler/source/diagnostic_table.h"

namespace compiler {

inline bool IsOfAnalysis(std::string_view code) {
  return (code >= code::kUselessAllow && code <= code::kCertainEnd) ||
         (code >= code::kUnreachablePhase && code <= code::kPaidCircle) ||
         (code >= code::kNotOnboard && code <= code::kConstantObservation) ||
         code == code::kStartBeyondStop || code == code::kConstantPotential;
}

}  // namespace compiler
