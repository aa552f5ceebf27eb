// A learned policy as a C header that needs nothing else.
#pragma once

#include <string>

#include "runtime/analysis/export/policy.h"

namespace runtime {

// The text of a header in C99, which C++ reads as well. It has the names and units of what is
// observed and of the joints as enumerators, the number of them, the time between two decisions,
// and
//
//   void policy_step(const float observation[], float joint_targets[]);
//
// The function keeps nothing, allocates nothing, and calls nothing but tanhf.
std::string CHeaderOf(const ExportedPolicy& policy);

}  // namespace runtime
