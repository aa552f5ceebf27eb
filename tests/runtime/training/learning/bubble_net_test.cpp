#include "runtime/training/learning/bubble_net.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/runtime/training/learning/test_robot.h"

namespace runtime {
namespace {

const GaussianNet& Bq01() {
  static const GaussianNet net = BubbleNet(PackSpheres(HumanoidNet("bq01"), 1), Norm::kEuclidean);
  return net;
}

// The published net of the same size and box, made from another random start: radius 0.8608, so the
// deviation 0.6 R = 0.5165; neighbor distances 1.65 .. 1.72, median 1.689.
TEST(BubbleNet, Bq01IsLikeThePublishedOne) {
  EXPECT_EQ(Bq01().units(), 300);
  ASSERT_EQ(Bq01().dimensions(), 5);
  for (const double deviation : Bq01().deviations()) EXPECT_NEAR(deviation, 0.51645, 0.01);
  Eigen::VectorXd distances = Bq01().neighbor_distances();
  std::sort(distances.begin(), distances.end());
  EXPECT_NEAR(distances[0], 1.65, 0.03);
  EXPECT_NEAR(distances[150], 1.689, 0.01);
  EXPECT_NEAR(distances[299], 1.72, 0.01);
}

TEST(BubbleNet, FeaturesOfBq01ArePeakedAtTheCenters) {
  Eigen::VectorXd features(300);
  double sum = 0;
  for (int k = 0; k < 300; ++k) {
    Bq01().Evaluate(Bq01().centers().row(k).transpose(), features);
    sum += features[k];
  }
  EXPECT_NEAR(sum / 300, 0.96, 0.01);
}

// Published: deviation 0.34586, neighbor distances 1.06 .. 1.15.
TEST(BubbleNet, Bq3dof60IsLikeThePublishedOne) {
  const GaussianNet net = BubbleNet(PackSpheres(HumanoidNet("bq3dof60"), 1), Norm::kEuclidean);
  EXPECT_EQ(net.units(), 60);
  EXPECT_NEAR(net.deviations()[0], 0.34586, 0.01);
  EXPECT_NEAR(net.neighbor_distances().minCoeff(), 1.06, 0.02);
  EXPECT_NEAR(net.neighbor_distances().maxCoeff(), 1.15, 0.02);
}

// At rest no spring can be compressed by much more than the inflating force over its stiffness,
// 0.1, and the faces' springs begin 0.2 R inside.
TEST(BubbleNet, CentersStayInTheBox) {
  const robot::NetDescription& box = HumanoidNet("bq01");
  const double inset = 0.2 * Bq01().deviations()[0] / 0.6 - 0.11;
  for (int i = 0; i < 5; ++i) {
    EXPECT_GT(Bq01().centers().col(i).minCoeff(), box.low[i] + inset);
    EXPECT_LT(Bq01().centers().col(i).maxCoeff(), box.high[i] - inset);
  }
}

TEST(BubbleNet, EqualSeedsGiveEqualNets) {
  const robot::NetDescription& description = HumanoidNet("bq3dof60");
  const GaussianNet first = BubbleNet(PackSpheres(description, 7), Norm::kEuclidean);
  const GaussianNet second = BubbleNet(PackSpheres(description, 7), Norm::kEuclidean);
  const GaussianNet other = BubbleNet(PackSpheres(description, 8), Norm::kEuclidean);
  EXPECT_EQ(first.centers(), second.centers());
  EXPECT_EQ(first.deviations(), second.deviations());
  EXPECT_NE(first.centers(), other.centers());
}

TEST(BubbleNet, OneBubbleComesToRestInTheMiddle) {
  robot::NetDescription net;
  net.kind = robot::NetKind::kBubble;
  net.units = 1;
  net.low = {0, 0};
  net.high = {1, 1};
  const GaussianNet one = BubbleNet(PackSpheres(net, 1), Norm::kEuclidean);
  EXPECT_NEAR(one.centers()(0, 0), 0.5, 0.05);
  EXPECT_NEAR(one.centers()(0, 1), 0.5, 0.05);
}

}  // namespace
}  // namespace runtime
