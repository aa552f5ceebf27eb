#include "plugins/robot/rotation.h"

#include <gmock/gmock.h>

#include <cmath>

namespace robot {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::IsNan;

TEST(Rotation, TurnsTheAxes) {
  EXPECT_THAT(RotationMatrix({1, 0, 0, 0}), ElementsAre(1, 0, 0, 0, 1, 0, 0, 0, 1));
  // A quarter about z: x becomes y.
  EXPECT_THAT(RotationMatrix({1, 0, 0, 1}), ElementsAre(0, -1, 0, 1, 0, 0, 0, 0, 1));
  // Half a turn about y, and a third about the diagonal: x becomes y, y becomes z.
  EXPECT_THAT(RotationMatrix({0, 0, 3, 0}), ElementsAre(-1, 0, 0, 0, 1, 0, 0, 0, -1));
  EXPECT_THAT(RotationMatrix({0.5, 0.5, 0.5, 0.5}), ElementsAre(0, 0, 1, 1, 0, 0, 0, 1, 0));
}

TEST(Rotation, IsOrthonormalWhateverTheLength) {
  const auto m = RotationMatrix({0.3, -0.7, 1.9, 0.2});
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      double dot = 0;
      for (int row = 0; row < 3; ++row) dot += m[3 * row + i] * m[3 * row + j];
      EXPECT_NEAR(dot, i == j ? 1 : 0, 1e-15);
    }
}

TEST(Rotation, OfLengthZeroIsNone) { EXPECT_THAT(RotationMatrix({0, 0, 0, 0}), Each(IsNan())); }

}  // namespace
}  // namespace robot
