#include "runtime/training/learning/exponential_schedule.h"

#include <gtest/gtest.h>

namespace runtime {
namespace {

// 0.3 exp(-0.002 * 895) = 0.050088, 0.3 exp(-0.002 * 896) = 0.049988.
TEST(ExponentialSchedule, LearningRateReachesItsMinimumAfter896Episodes) {
  const ExponentialSchedule rate{.initial = 0.3, .decay = 0.002, .minimum = 0.05};
  EXPECT_EQ(rate.At(0), 0.3);
  EXPECT_NEAR(rate.At(500), 0.11036383235, 1e-11);
  EXPECT_NEAR(rate.At(895), 0.05008805090, 1e-11);
  EXPECT_EQ(rate.At(896), 0.05);
  EXPECT_EQ(rate.At(100000), 0.05);
}

// 5 exp(-0.004 n): the published 0.68, 0.092 and 0.0017 to more digits.
TEST(ExponentialSchedule, TemperatureFallsAsInTheExperiments) {
  const ExponentialSchedule temperature{.initial = 5, .decay = 0.004, .minimum = 1e-300};
  EXPECT_NEAR(temperature.At(500), 0.6766764162, 1e-10);
  EXPECT_NEAR(temperature.At(1000), 0.0915781944, 1e-10);
  EXPECT_NEAR(temperature.At(2000), 0.0016773131, 1e-10);
  EXPECT_EQ(temperature.At(1000000), 1e-300);
}

}  // namespace
}  // namespace runtime
