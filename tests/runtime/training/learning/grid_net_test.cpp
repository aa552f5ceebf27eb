#include "runtime/training/learning/grid_net.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/runtime/training/learning/test_robot.h"

namespace runtime {
namespace {

robot::NetDescription Grid(std::vector<int> counts, std::vector<double> low,
                           std::vector<double> high) {
  robot::NetDescription net;
  net.kind = robot::NetKind::kGrid;
  net.counts = std::move(counts);
  net.low = std::move(low);
  net.high = std::move(high);
  return net;
}

TEST(GridNet, PlacesCentersFromEndToEndFirstCoordinateFastest) {
  const GaussianNet net = GridNet(Grid({2, 3}, {0, -1}, {1, 1}), Norm::kEuclidean);
  Eigen::MatrixXd expected(6, 2);
  expected << 0, -1,  //
      1, -1,          //
      0, 0,           //
      1, 0,           //
      0, 1,           //
      1, 1;
  EXPECT_EQ(net.centers(), expected);
  EXPECT_EQ(net.deviations(), Eigen::Vector2d(0.375, 0.375));  // 3/8 of the spacing 1
}

TEST(GridNet, OneCenterLiesInTheMiddleAndIsIgnored) {
  const GaussianNet net = GridNet(Grid({2, 1, 3}, {0, -1, 2}, {1, 3, 2}), Norm::kEuclidean);
  ASSERT_EQ(net.units(), 6);
  EXPECT_EQ(net.centers().col(1), Eigen::VectorXd::Constant(6, 1));
  EXPECT_EQ(net.centers().col(2), Eigen::VectorXd::Constant(6, 2));
  EXPECT_EQ(net.deviations()[1], 1000);
  EXPECT_EQ(net.deviations()[2], 1000);
}

struct PublishedNet {
  const char* name;
  int units;
  std::vector<double> deviations;
  double neighbor_distance;  // of every unit; 0: not published
};

void PrintTo(const PublishedNet& net, std::ostream* out) { *out << net.name; }

class HumanoidGridNet : public testing::TestWithParam<PublishedNet> {};

TEST_P(HumanoidGridNet, HasThePublishedFigures) {
  const PublishedNet& published = GetParam();
  const GaussianNet net = GridNet(HumanoidNet(published.name), Norm::kEuclidean);
  EXPECT_EQ(net.units(), published.units);
  ASSERT_EQ(net.dimensions(), static_cast<int>(published.deviations.size()));
  for (int i = 0; i < net.dimensions(); ++i) {
    EXPECT_NEAR(net.deviations()[i], published.deviations[i], 1e-6) << i;
  }
  if (published.neighbor_distance == 0) return;
  EXPECT_NEAR(net.neighbor_distances().minCoeff(), published.neighbor_distance, 1e-12);
  EXPECT_NEAR(net.neighbor_distances().maxCoeff(), published.neighbor_distance, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    , HumanoidGridNet,
    testing::Values(PublishedNet{"4asym_g4", 256, {0.58875, 0.58875, 0.785, 0.785}, 1.57},
                    PublishedNet{"4asym_g5", 625, {0.441562, 0.441562, 0.58875, 0.58875}, 1.1775},
                    PublishedNet{"q3", 243, {2.0 / 3, 0.5, 0.5, 0.353553, 0.894427}, 1.315},
                    PublishedNet{"3_g5", 125, {0.441562, 0.294375, 0.246562}, 0},
                    PublishedNet{"3_g7", 343, {0.294375, 0.19625, 0.164375}, 0}),
    [](const auto& test) { return "net_" + std::string(test.param.name); });

TEST(HumanoidNet, FeaturesOf4asymG4ArePeakedAtTheCenters) {
  const GaussianNet net = GridNet(HumanoidNet("4asym_g4"), Norm::kMax);
  Eigen::VectorXd features(net.units());
  double sum = 0;
  for (int k = 0; k < net.units(); ++k) {
    net.Evaluate(net.centers().row(k).transpose(), features);
    sum += features[k];
  }
  EXPECT_NEAR(sum / net.units(), 0.85, 0.01);
}

}  // namespace
}  // namespace runtime
