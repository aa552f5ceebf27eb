#include "runtime/training/run/estimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace runtime {
namespace {

// Deviations -3, -1, 1, 3: variance 20 / 3, standard error sqrt(20 / 3 / 4) = 1.29099, and
// Student's t for 3 degrees of freedom is 3.18245.
TEST(EstimateMean, HasTheIntervalOfStudentsT) {
  const Estimate estimate = EstimateMean(std::vector<double>{1, 3, 5, 7});
  EXPECT_EQ(estimate.count, 4);
  EXPECT_DOUBLE_EQ(estimate.mean, 4);
  EXPECT_NEAR(estimate.low, 4 - 1.29099 * 3.18245, 1e-4);
  EXPECT_NEAR(estimate.high, 4 + 1.29099 * 3.18245, 1e-4);
  EXPECT_EQ(estimate.least, 1);
  EXPECT_EQ(estimate.greatest, 7);
}

TEST(EstimateMean, LeavesOutWhatIsNotANumber) {
  const Estimate estimate = EstimateMean(std::vector<double>{NAN, 2, NAN, 4});
  EXPECT_EQ(estimate.count, 2);
  EXPECT_DOUBLE_EQ(estimate.mean, 3);
}

TEST(EstimateMean, OfOneOrTwoValuesHasNoInterval) {
  EXPECT_EQ(EstimateMean(std::vector<double>{5}).mean, 5);
  const Estimate estimate = EstimateMean(std::vector<double>{4, 6});
  EXPECT_EQ(estimate.mean, 5);
  EXPECT_TRUE(std::isnan(estimate.low));
  EXPECT_TRUE(std::isnan(estimate.high));
}

TEST(EstimateMean, OfNothingIsNotANumber) {
  const Estimate estimate = EstimateMean({});
  EXPECT_EQ(estimate.count, 0);
  EXPECT_TRUE(std::isnan(estimate.mean));
}

TEST(Median, IsTheValueInTheMiddle) {
  const double none = std::nan("");
  EXPECT_DOUBLE_EQ(Median({7, none, 1, 2}), 2);
  EXPECT_DOUBLE_EQ(Median({4, 10, 1, 2}), 3);
  EXPECT_TRUE(std::isnan(Median({none})));
}

}  // namespace
}  // namespace runtime
