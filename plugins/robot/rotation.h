// Rotations in space, body to world.
#pragma once

#include <array>

namespace robot {

// The rotation matrix, row by row, of a quaternion w, x, y, z, which need not be of length 1; not
// numbers where its length is 0.
std::array<double, 9> RotationMatrix(const std::array<double, 4>& quaternion);

}  // namespace robot
