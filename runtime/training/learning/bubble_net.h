// A Gaussian network whose centers fill a box evenly, as bubbles do that are blown up in it.
#pragma once

#include <cstdint>

#include "plugins/robot/robot_description.h"
#include "runtime/training/learning/gaussian_net.h"

namespace runtime {

// Spheres of one common radius in a box.
struct Spheres {
  Eigen::MatrixXd centers;  // one column for each sphere
  double radius = 0;
};

// Spheres of a growing radius push each other and the faces of the box away until they are at rest,
// which takes a quarter of a second for the humanoid's nets. Equal seeds give equal spheres.
Spheres PackSpheres(const robot::NetDescription& net, uint64_t seed);

// Changes whenever PackSpheres() gives other spheres than before.
inline constexpr int kPackingVersion = 1;

// A net with a unit in each sphere and the deviation 0.6 R in every dimension.
GaussianNet BubbleNet(const Spheres& spheres, Norm norm);

}  // namespace runtime
