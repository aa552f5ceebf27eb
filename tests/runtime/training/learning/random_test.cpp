#include "runtime/training/learning/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace runtime {
namespace {

// The first number of the 64-bit Mersenne twister from the seed 5489 is 14514284786278117030 (its
// authors' table); its upper 53 bits over 2^53.
TEST(Random, MakesThePublishedNumbers) {
  Random random(5489);
  EXPECT_EQ(random.Uniform(), 0.7868209548678019);
}

TEST(Random, StaysBelowOneAndFillsTheInterval) {
  Random random(1);
  double smallest = 1, largest = 0, sum = 0;
  for (int i = 0; i < 10000; ++i) {
    const double uniform = random.Uniform();
    smallest = std::min(smallest, uniform);
    largest = std::max(largest, uniform);
    sum += uniform;
  }
  EXPECT_GE(smallest, 0);
  EXPECT_LT(smallest, 0.001);
  EXPECT_LT(largest, 1);
  EXPECT_GT(largest, 0.999);
  EXPECT_NEAR(sum / 10000, 0.5, 0.01);  // 3.5 standard deviations of the mean
}

TEST(Random, NormalNumbersHaveMeanZeroAndVarianceOne) {
  Random random(1);
  double sum = 0, squares = 0, fourths = 0;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const double normal = random.Normal();
    sum += normal;
    squares += normal * normal;
    fourths += std::pow(normal, 4);
  }
  EXPECT_NEAR(sum / kCount, 0, 0.03);  // 4 standard deviations
  EXPECT_NEAR(squares / kCount, 1, 0.04);
  EXPECT_NEAR(fourths / kCount, 3, 0.3);
}

TEST(Random, GoesOnWhereItWasSaved) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) random.Uniform();
  std::stringstream stream;
  stream << random;
  Random restored(99);
  stream >> restored;
  ASSERT_TRUE(stream);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(restored.Uniform(), random.Uniform());
}

}  // namespace
}  // namespace runtime
