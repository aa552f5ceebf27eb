// A Gaussian network whose centres fill a box evenly, as bubbles do that are blown up in it.
#pragma once

#include <cstdint>

#include "plugins/robot/robot_description.h"
#include "runtime/learning/gaussian_net.h"

namespace runtime {

// Spheres of one common, growing radius R push each other and the faces of the box away until they
// are at rest; the deviation is then 0.6 R in every dimension. Equal seeds give equal nets.
GaussianNet BubbleNet(const robot::NetDescription& net, uint64_t seed, Norm norm);

}  // namespace runtime
