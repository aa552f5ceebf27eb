#include "runtime/training/learning/running_moments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace runtime {
namespace {

TEST(RunningMoments, AreMeanAndDeviationOfAll) {
  RunningMoments moments(2);
  for (const double x : {1.0, 2.0, 6.0}) moments.Add(Eigen::Vector2d(x, 7));
  EXPECT_NEAR(moments.Mean(0), 3, 1e-15);
  EXPECT_NEAR(moments.Deviation(0), std::sqrt(14.0 / 3), 1e-8);
  EXPECT_EQ(moments.Mean(1), 7);
  EXPECT_NEAR(moments.Deviation(1), 1e-4, 1e-15);  // has not varied
}

TEST(RunningMoments, OfNothingChangeNothing) {
  const RunningMoments moments(1);
  EXPECT_EQ(moments.Mean(0), 0);
  EXPECT_EQ(moments.Deviation(0), 1);
}

TEST(RunningMoments, GoOnFromWhatWasSaved) {
  RunningMoments moments(1);
  for (const double x : {0.1, 1e6}) moments.Add(Eigen::VectorXd{{x}});
  std::stringstream stream;
  moments.Save(stream);
  RunningMoments other(1);
  other.Load(stream);
  for (RunningMoments* each : {&moments, &other}) each->Add(Eigen::VectorXd{{0.3}});
  EXPECT_EQ(other.Mean(0), moments.Mean(0));
  EXPECT_EQ(other.Deviation(0), moments.Deviation(0));
}

}  // namespace
}  // namespace runtime
