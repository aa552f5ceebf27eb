// Packed spheres that are computed once and then read from the user's cache.
#pragma once

#include "runtime/training/learning/bubble_net.h"

namespace runtime {

// What PackSpheres() gives, bit for bit. Where there is no cache, or what it holds is damaged, the
// spheres are packed again.
Spheres KeptSpheres(const robot::NetDescription& net, uint64_t seed);

}  // namespace runtime
