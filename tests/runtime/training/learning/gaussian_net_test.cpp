#include "runtime/training/learning/gaussian_net.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "runtime/training/learning/random.h"

namespace runtime {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

MatrixXd ThreeCenters() {
  MatrixXd centers(3, 2);
  centers << 0, 0,  //
      1, 0,         //
      0, 2;
  return centers;
}

VectorXd Features(const GaussianNet& net, const VectorXd& point) {
  VectorXd features(net.units());
  net.Evaluate(point, features);
  return features;
}

// At (0.25, 0.5), with deviations 0.5 and 1, the exponents are
//   unit 0: -(0.0625 / 0.5 + 0.25 / 2) = -0.25
//   unit 1: -(0.5625 / 0.5 + 0.25 / 2) = -1.25
//   unit 2: -(0.0625 / 0.5 + 2.25 / 2) = -1.25
// so phi_0 = 1 / (1 + 2 exp(-1)), and the others share the rest.
TEST(GaussianNet, GivesTheFeaturesOfTheFormula) {
  const GaussianNet net(ThreeCenters(), Vector2d(0.5, 1), Norm::kEuclidean);
  const VectorXd features = Features(net, Vector2d(0.25, 0.5));
  EXPECT_NEAR(features[0], 0.5761168847658291, 1e-15);
  EXPECT_NEAR(features[1], 0.2119415576170854, 1e-15);
  EXPECT_NEAR(features[2], 0.2119415576170854, 1e-15);
}

TEST(GaussianNet, FeaturesAddUpToOneHoweverFarThePoint) {
  const GaussianNet net(ThreeCenters(), Vector2d(0.5, 1), Norm::kEuclidean);
  for (const double far : {0.0, 10.0, 1e3, 1e6, -1e6}) {
    EXPECT_NEAR(Features(net, Vector2d(far, far / 3)).sum(), 1, 1e-14) << far;
  }
  EXPECT_EQ(Features(net, Vector2d(1e6, 0))[1], 1);  // the nearest unit is all that is left
}

// The general definition, term by term: every state dimension, a covariance for each unit, the
// determinant; ignored dimensions with center 0 and the inverse variance 1e-6.
VectorXd FeaturesByDefinition(const MatrixXd& centers, const VectorXd& inverse_variances,
                              const VectorXd& state) {
  std::vector<double> values;
  double sum = 0;
  for (int k = 0; k < centers.rows(); ++k) {
    double exponent = 0, determinant = 1;
    for (int i = 0; i < centers.cols(); ++i) {
      const double difference = state[i] - centers(k, i);
      exponent += -0.5 * inverse_variances[i] * difference * difference;
      determinant *= inverse_variances[i];
    }
    const double dimensions = static_cast<double>(centers.cols());
    values.push_back(std::pow(2 * std::numbers::pi, -dimensions / 2) * std::sqrt(determinant) *
                     std::exp(exponent));
    sum += values.back();
  }
  VectorXd features(centers.rows());
  for (int k = 0; k < centers.rows(); ++k) features[k] = values[k] / sum;
  return features;
}

TEST(GaussianNet, IgnoredDimensionsOfTheStateCancel) {
  constexpr int kUnits = 20, kState = 9, kFirst = 3, kUsed = 4;
  Random random(1);
  MatrixXd centers(kUnits, kUsed);
  for (double& element : centers.reshaped()) element = 4 * random.Uniform() - 2;
  const VectorXd deviations = Eigen::Vector4d(0.5, 0.7, 1, 0.9);
  const GaussianNet net(centers, deviations, Norm::kEuclidean);

  MatrixXd full_centers = MatrixXd::Zero(kUnits, kState);
  full_centers.middleCols(kFirst, kUsed) = centers;
  VectorXd inverse_variances = VectorXd::Constant(kState, 1e-6);
  inverse_variances.segment(kFirst, kUsed) = deviations.array().square().inverse();

  for (int repetition = 0; repetition < 10; ++repetition) {
    VectorXd state(kState);
    for (double& element : state) element = 6 * random.Uniform() - 3;
    const VectorXd expected = FeaturesByDefinition(full_centers, inverse_variances, state);
    const VectorXd features = Features(net, state.segment(kFirst, kUsed));
    EXPECT_LT((features - expected).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(GaussianNet, NeighborDistanceIsThatOfTheNearestCenter) {
  const GaussianNet net(ThreeCenters(), Vector2d(0.1, 0.2), Norm::kEuclidean);
  EXPECT_EQ(net.neighbor_distances(), Eigen::Vector3d(1, 1, 2));
}

TEST(GaussianNet, NeighborDistanceUsesTheNorm) {
  MatrixXd centers(2, 2);
  centers << 0, 0, 3, 4;
  const Vector2d deviations(0.1, 0.1);
  EXPECT_EQ(GaussianNet(centers, deviations, Norm::kEuclidean).neighbor_distances(),
            Vector2d(5, 5));
  EXPECT_EQ(GaussianNet(centers, deviations, Norm::kMax).neighbor_distances(), Vector2d(4, 4));
}

TEST(GaussianNet, NeighborDistanceIsAtLeastTheLargestFiniteDeviation) {
  const GaussianNet wide(ThreeCenters(), Vector2d(0.1, 1.5), Norm::kEuclidean);
  EXPECT_EQ(wide.neighbor_distances(), Eigen::Vector3d(1.5, 1.5, 2));
  const GaussianNet ignored(ThreeCenters(), Vector2d(1.5, 1000), Norm::kEuclidean);
  EXPECT_EQ(ignored.neighbor_distances(), Eigen::Vector3d(1.5, 1.5, 2));
  const GaussianNet all_ignored(ThreeCenters(), Vector2d(500, 1000), Norm::kEuclidean);
  EXPECT_EQ(all_ignored.neighbor_distances(), Eigen::Vector3d::Constant(500));
}

TEST(GaussianNet, OneUnitIsOnItsOwn) {
  const GaussianNet net(MatrixXd::Zero(1, 2), Vector2d(0.5, 0.25), Norm::kEuclidean);
  EXPECT_EQ(net.neighbor_distances()[0], 0.5);
  EXPECT_EQ(Features(net, Vector2d(3, 4))[0], 1);
}

}  // namespace
}  // namespace runtime
