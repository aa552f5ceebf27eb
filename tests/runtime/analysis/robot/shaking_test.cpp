#include "runtime/analysis/robot/shaking.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace runtime {
namespace {

// Of one joint with this speed over time, in steps of 1 ms for a second.
double ShakingOf(const std::function<double(double)>& rate) {
  Shaking shaking(1, 0.001, 0.5);
  for (int i = 1; i <= 1000; ++i) shaking.Add(0.001 * i, std::vector{rate(0.001 * i)});
  return shaking.Worst().second;
}

TEST(Shaking, LeavesOutWhatAJointDoes) {
  EXPECT_NEAR(ShakingOf([](double) { return 3; }), 0, 1e-6);
  EXPECT_NEAR(ShakingOf([](double t) { return 20 - 100 * t; }), 0, 1e-5);
  const auto swing = [](double t) { return 6 * std::sin(2 * std::numbers::pi * t); };
  EXPECT_LT(ShakingOf(swing), 0.05);
}

TEST(Shaking, IsTheMeanSquareOfWhatIsFast) {
  const auto shake = [](double t) { return 2 * t + std::sin(2 * std::numbers::pi * 100 * t); };
  EXPECT_NEAR(ShakingOf(shake), std::sqrt(0.5), 0.01);
}

TEST(Shaking, DoesNotSeeABlowNorWhatWasBefore) {
  EXPECT_EQ(ShakingOf([](double t) { return t > 0.7 && t < 0.705 ? 50 : 0; }), 0);
  EXPECT_EQ(ShakingOf([](double t) { return t < 0.49 ? std::sin(1000 * t) : 0; }), 0);
}

TEST(Shaking, NamesTheJointThatShakesMost) {
  Shaking shaking(3, 0.001, 0);
  for (int i = 1; i <= 200; ++i) {
    const double sign = i % 2 == 0 ? 1 : -1;
    shaking.Add(0.001 * i, std::vector{0.0, 2 * sign, sign});
  }
  EXPECT_EQ(shaking.Worst().first, 1);
  EXPECT_NEAR(shaking.Worst().second, 2, 0.01);
  EXPECT_EQ(Shaking(0, 0.001, 0).Worst().first, -1);
}

}  // namespace
}  // namespace runtime
