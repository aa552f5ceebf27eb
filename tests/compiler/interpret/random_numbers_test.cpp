// Random numbers against the published test vectors, and against what they should look like.
#include "compiler/interpret/random_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace compiler {
namespace {

using testing::ElementsAre;

// The known answers that the authors of Philox publish with their library Random123.
TEST(Philox, GivesTheKnownAnswers) {
  EXPECT_THAT(Philox({0, 0}, {0, 0, 0, 0}),
              ElementsAre(0x6627E8D5, 0xE169C58D, 0xBC57AC4C, 0x9B00DBD8));
  EXPECT_THAT(Philox({0xFFFFFFFF, 0xFFFFFFFF}, {0xFFFFFFFF, 0xFFFFFFFF, 0xFFFFFFFF, 0xFFFFFFFF}),
              ElementsAre(0x408F276D, 0x41C83B0E, 0xA20BC7C6, 0x6D5451FD));
  EXPECT_THAT(Philox({0xA4093822, 0x299F31D0}, {0x243F6A88, 0x85A308D3, 0x13198A2E, 0x03707344}),
              ElementsAre(0xD16CFE09, 0x94FDCCEB, 0x5001E420, 0x24126EA1));
}

// Computed by hand from the first of the known answers: 27 and 26 bits of each pair of words.
TEST(Draws, AreMadeOfTheUpperBits) {
  const double unit = (0x6627E8D5 / 32 + (0xE169C58D / 64) / 67108864.0) / 134217728.0;
  EXPECT_EQ(DrawUniform({}, 0, 0, 0, 1), unit);
  EXPECT_EQ(DrawUniform({}, 0, 0, -3, 5), -3 + 8 * unit);
  EXPECT_EQ(DrawChoice({}, 0, 0, 5), static_cast<size_t>(unit * 5));
  const double other = (0xBC57AC4C / 32 + (0x9B00DBD8 / 64) / 67108864.0) / 134217728.0;
  EXPECT_DOUBLE_EQ(DrawNormal({}, 0, 0, 1, 2),
                   1 + 2 * std::sqrt(-2 * std::log(1 - unit)) * std::cos(2 * M_PI * other));
}

TEST(Draws, DependOnEachPartOfTheirPlace) {
  const DrawPlace place{7, 11, 13};
  const double first = DrawUniform(place, 17, 19, 0, 1);
  EXPECT_EQ(DrawUniform(place, 17, 19, 0, 1), first);
  EXPECT_NE(DrawUniform({8, 11, 13}, 17, 19, 0, 1), first);
  EXPECT_NE(DrawUniform({7 + (uint64_t{1} << 40), 11, 13}, 17, 19, 0, 1), first);
  EXPECT_NE(DrawUniform({7, 12, 13}, 17, 19, 0, 1), first);
  EXPECT_NE(DrawUniform({7, 11, 14}, 17, 19, 0, 1), first);
  EXPECT_NE(DrawUniform(place, 18, 19, 0, 1), first);
  EXPECT_NE(DrawUniform(place, 17, 20, 0, 1), first);
}

TEST(Draws, StayInTheirRange) {
  for (uint32_t i = 0; i < 1000; ++i) {
    const DrawPlace place{1, 2, i};
    const double number = DrawUniform(place, 0, 0, 0.1, 0.1 + 1e-16);
    EXPECT_GE(number, 0.1);
    EXPECT_LE(number, 0.1 + 1e-16);
    EXPECT_LE(DrawUniform(place, 0, 0, 3, -3), 3);  // a range that is upside down
    EXPECT_GE(DrawUniform(place, 0, 0, 3, -3), -3);
    EXPECT_LT(DrawChoice(place, 0, 0, 3), 3u);
  }
}

// Mean and variance of 100,000 numbers, within five standard errors.
TEST(Draws, HaveTheRightMoments) {
  constexpr int kCount = 100'000;
  double sum = 0, squares = 0, normal_sum = 0, normal_squares = 0;
  std::vector<int> chosen(4);
  for (uint32_t i = 0; i < kCount; ++i) {
    const DrawPlace place{42, 1, i};
    const double uniform = DrawUniform(place, 0, 0, -1, 1);
    const double normal = DrawNormal(place, 0, 1, 3, 2);
    sum += uniform;
    squares += uniform * uniform;
    normal_sum += normal;
    normal_squares += (normal - 3) * (normal - 3);
    ++chosen[DrawChoice(place, 0, 2, chosen.size())];
  }
  const double root = std::sqrt(kCount);
  EXPECT_NEAR(sum / kCount, 0, 5 * std::sqrt(1 / 3.0) / root);
  EXPECT_NEAR(squares / kCount, 1 / 3.0, 5 * std::sqrt(4 / 45.0) / root);
  EXPECT_NEAR(normal_sum / kCount, 3, 5 * 2 / root);
  EXPECT_NEAR(normal_squares / kCount, 4, 5 * 4 * std::sqrt(2) / root);
  for (const int count : chosen) EXPECT_NEAR(count, kCount / 4.0, 5 * std::sqrt(kCount * 3 / 16.0));
}

}  // namespace
}  // namespace compiler
