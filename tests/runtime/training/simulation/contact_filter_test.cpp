#include "runtime/training/simulation/contact_filter.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace runtime {
namespace {

using Raw = std::vector<unsigned char>;

// Seconds until the flag of a filter that has settled at `from` shows the opposite.
double Delay(double time_step, unsigned char from) {
  ContactFilter filter(1, time_step);
  filter.Start(Raw{from});
  const bool before = filter.flag(0);
  EXPECT_EQ(before, from != 0);
  const Raw raw = {static_cast<unsigned char>(1 - from)};
  for (int step = 1; step < 100000; ++step) {
    filter.Update(raw);
    if (filter.flag(0) != before) return step * time_step;
  }
  return INFINITY;
}

TEST(ContactFilter, ShowsATouchAfterEightMilliseconds) {
  EXPECT_NEAR(Delay(0.0002, 0), 0.0080, 1e-9);
}

TEST(ContactFilter, ShowsItsEndAfterThirtyNineMilliseconds) {
  EXPECT_NEAR(Delay(0.0002, 1), 0.0386, 1e-9);
}

TEST(ContactFilter, DelaysDoNotDependOnTheLengthOfThePhysicsStep) {
  for (const double time_step : {0.001, 0.005 / 3, 0.0025, 0.005}) {
    EXPECT_GE(Delay(time_step, 0), 0.0080 - 0.0002) << time_step;
    EXPECT_LT(Delay(time_step, 0), 0.0080 + time_step) << time_step;
    EXPECT_GE(Delay(time_step, 1), 0.0386 - 0.0003) << time_step;
    EXPECT_LT(Delay(time_step, 1), 0.0386 + time_step) << time_step;
  }
}

bool ShowsATouchOf(int steps) {
  ContactFilter filter(1, 0.0002);
  filter.Start(Raw{0});
  bool shown = false;
  for (int step = 0; step < 1000; ++step) {
    filter.Update(Raw{static_cast<unsigned char>(step < steps)});
    shown = shown || filter.flag(0);
  }
  return shown;
}

TEST(ContactFilter, ShowsOnlyTouchesOfMoreThanThreeMilliseconds) {
  EXPECT_FALSE(ShowsATouchOf(16));
  EXPECT_TRUE(ShowsATouchOf(17));
}

// The same recursion as a linear map, taken to its n-th power: v(n) = A^n v(0) + (1 + ... +
// A^(n-1)) b.
TEST(ContactFilter, AgreesWithTheClosedFormOfTheLinearRecursion) {
  const double a = 1 - std::exp(-2 * std::numbers::pi * 10 * 0.0002);
  EXPECT_NEAR(a, 0.01248774, 1e-8);
  const double q = 0.8;
  Eigen::Matrix2d map;
  map << 1 - a / q, -a, a * (1 - a / q), 1 - a * a;
  const Eigen::Vector2d push(a, a * a);
  const Eigen::EigenSolver<Eigen::Matrix2d> eigen(map);
  const Eigen::Vector2d fixed = (Eigen::Matrix2d::Identity() - map).inverse() * push;
  EXPECT_NEAR(fixed[1], 1, 1e-12);
  const auto after = [&](int n) {  // from rest, with raw = 1
    const Eigen::Vector2cd powers = eigen.eigenvalues().array().pow(n);
    const Eigen::Matrix2cd power =
        eigen.eigenvectors() * powers.asDiagonal() * eigen.eigenvectors().inverse();
    return (fixed - power.real() * fixed).eval();
  };
  int first = 1;
  while (after(first)[1] <= 0.1) ++first;
  EXPECT_EQ(first, 40);  // 8.0 ms
  ContactFilter filter(1, 0.0002);
  filter.Start(Raw{0});
  for (int n = 1; n <= 500; ++n) {
    filter.Update(Raw{1});
    ASSERT_EQ(filter.flag(0), after(n)[1] > 0.1) << n;
  }
}

TEST(ContactFilter, LinksAreIndependent) {
  ContactFilter filter(3, 0.0002);
  filter.Start(Raw{0, 1, 0});
  EXPECT_FALSE(filter.flag(0));
  EXPECT_TRUE(filter.flag(1));
  for (int n = 0; n < 40; ++n) filter.Update(Raw{0, 1, 1});
  EXPECT_FALSE(filter.flag(0));
  EXPECT_TRUE(filter.flag(1));
  EXPECT_TRUE(filter.flag(2));
}

}  // namespace
}  // namespace runtime
