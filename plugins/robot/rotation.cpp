#include "plugins/robot/rotation.h"

namespace robot {

std::array<double, 9> RotationMatrix(const std::array<double, 4>& quaternion) {
  const auto [w, x, y, z] = quaternion;
  const double s = 2 / (w * w + x * x + y * y + z * z);
  return {1 - s * (y * y + z * z), s * (x * y - w * z),     s * (x * z + w * y),
          s * (x * y + w * z),     1 - s * (x * x + z * z), s * (y * z - w * x),
          s * (x * z - w * y),     s * (y * z + w * x),     1 - s * (x * x + y * y)};
}

}  // namespace robot
