#pragma once

#include "plugins/robot/robot_description.h"
#include "runtime/training/learning/gaussian_net.h"

namespace runtime {

// Centers evenly spaced along each coordinate, both ends of its range included; the first
// coordinate varies fastest. The deviation is that of the description, or else 3/8 of the
// spacing. A coordinate with a count of 1 or
// without extent has its centers in the middle of its range and is as good as ignored (deviation
// 1000).
GaussianNet GridNet(const robot::NetDescription& net, Norm norm);

}  // namespace runtime
