#include "runtime/training/learning/gae.h"

#include <gtest/gtest.h>

#include <array>

namespace runtime {
namespace {

constexpr GaeSettings kSettings{.discount = 0.9f, .lambda = 0.5f};
constexpr std::array<float, 3> kRewards = {1, 2, 3};

// delta = 3 + 0.9 * 2 - 1 = 3.8, 2 + 0.9 - 4 = -1.1, 1 + 3.6 - 0.5 = 4.1
// a = 3.8, -1.1 + 0.45 * 3.8 = 0.61, 4.1 + 0.45 * 0.61 = 4.3745
TEST(Gae, SumsWhatIsBetterThanExpected) {
  const std::array<float, 4> values = {0.5, 4, 1, 2};
  std::array<float, 3> advantages{};
  EstimateAdvantages(kRewards, values, kSettings, advantages);
  EXPECT_NEAR(advantages[2], 3.8, 1e-6);
  EXPECT_NEAR(advantages[1], 0.61, 1e-6);
  EXPECT_NEAR(advantages[0], 4.3745, 1e-6);
}

// With lambda = 1 an advantage and the value before it are the discounted rewards: 3,
// 2 + 2.7 = 4.7, 1 + 4.23 = 5.23.
TEST(Gae, AfterATerminalStateThereIsNothing) {
  const std::array<float, 4> values = {0.5, 4, 1, 0};
  std::array<float, 3> advantages{};
  EstimateAdvantages(kRewards, values, {.discount = 0.9f, .lambda = 1}, advantages);
  EXPECT_NEAR(advantages[2] + 1, 3, 1e-6);
  EXPECT_NEAR(advantages[1] + 4, 4.7, 1e-6);
  EXPECT_NEAR(advantages[0] + 0.5, 5.23, 1e-6);
}

}  // namespace
}  // namespace runtime
