#include "runtime/training/learning/mlp.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/runtime/training/learning/finite_difference.h"

namespace runtime {
namespace {

// y = 3 tanh(2 x_1 - x_2 + 0.5) + 4
TEST(Mlp, IsTanhBetweenLinearLayers) {
  Mlp<double> network({2, 1, 1});
  network.weights() << 2, -1, 0.5, 3, 4;
  Mlp<double>::Pass pass;
  const Eigen::MatrixXd inputs{{0.3, 0}, {0.7, 0}};
  const Eigen::MatrixXd& outputs = network.Forward(inputs, pass);
  EXPECT_NEAR(outputs(0, 0), 3 * std::tanh(0.4) + 4, 1e-15);
  EXPECT_NEAR(outputs(0, 1), 3 * std::tanh(0.5) + 4, 1e-15);
}

TEST(Mlp, WithoutHiddenLayersIsLinear) {
  Mlp<double> network({2, 2});
  network.weights() << 1, 2, 3, 4, 5, 6;
  Mlp<double>::Pass pass;
  EXPECT_EQ(network.Forward(Eigen::Vector2d(1, 10), pass), Eigen::Vector2d(36, 48));
}

TEST(Mlp, DerivativesAreThoseOfDifferences) {
  Random random(1);
  Mlp<double> network({5, 7, 4, 3});
  network.Randomize(1, random);
  network.weights() += 0.1 * RandomMatrix(network.weights().size(), 1, random);
  const Eigen::MatrixXd inputs = RandomMatrix(5, 6, random);
  const Eigen::MatrixXd slopes = RandomMatrix(3, 6, random);  // of the loss by the outputs
  Mlp<double>::Pass pass;
  const auto loss = [&] { return (network.Forward(inputs, pass).array() * slopes.array()).sum(); };
  const Eigen::VectorXd expected = DifferenceQuotients(network.weights(), loss);
  network.Forward(inputs, pass);
  Eigen::VectorXd gradient;
  network.Backward(inputs, slopes, pass, gradient);
  EXPECT_LT((gradient - expected).lpNorm<Eigen::Infinity>(), 1e-8);
}

TEST(Mlp, RandomWeightsKeepTheSizeOfTheirInputs) {
  Random random(1);
  Mlp<float> network({200, 300, 10});
  network.Randomize(0.01f, random);
  const float first = network.weights().head(200 * 300).squaredNorm() / (200 * 300);
  EXPECT_NEAR(first, 1.0 / 200, 1e-4);
  const float last = network.weights().segment(200 * 300 + 300, 3000).squaredNorm() / 3000;
  EXPECT_NEAR(last, 1e-4 / 300, 2e-8);
  EXPECT_TRUE(network.weights().segment(200 * 300, 300).isZero(0));
  EXPECT_TRUE(network.weights().tail(10).isZero(0));
}

}  // namespace
}  // namespace runtime
