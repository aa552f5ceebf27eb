#pragma once

#include <string>

#include "runtime/training/learning/policy_graph.h"

namespace runtime {

// The function policy_targets(seconds, joint_offsets, joint_targets) in C: the motion's place then,
// and the offsets. POLICY_TARGETS is defined before.
std::string CMotion(const PolicyMotion& motion);

}  // namespace runtime
