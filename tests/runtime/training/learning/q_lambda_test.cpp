#include "runtime/training/learning/q_lambda.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace runtime {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;
using Matrix = QLambda::Matrix;

constexpr double kUniformly = 1e9;  // a temperature at which all actions are equally likely
constexpr double kGreedily = 1e-300;

Matrix Rows(std::initializer_list<std::initializer_list<double>> rows) { return Matrix(rows); }

void ExpectNear(const Matrix& actual, const Matrix& expected) {
  EXPECT_LT((actual - expected).cwiseAbs().maxCoeff(), 1e-8) << actual;
}

// Three actions and the end of an episode by hand, with gamma = 0.9, lambda = 0.5, alpha = 0.5. The
// seed makes Boltzmann choose the actions 1, 0, 1, 2.
class ThreeActions : public testing::Test {
 protected:
  static constexpr double kAlpha = 0.5;
  const QLambda::Settings settings_{.discount = 0.9, .trace_decay = 0.5, .trace_max = 1};
  Random random_{61};
  QLambda q_{Rows({{1, 0}, {0, 2}, {0, 0}})};
  const VectorXd phi0_ = Vector2d(1, 0);
  const VectorXd phi1_ = Vector2d(0.5, 0.5);
  const VectorXd phi2_ = Vector2d(0, 1);

  void Step(double reward, const VectorXd& features) {
    q_.Step(reward, settings_, kAlpha, features, kUniformly, random_);
  }
};

TEST_F(ThreeActions, ChangeThetaAndTracesAsComputedByHand) {
  // Q(x0) = (1, 0, 0).
  q_.StartEpisode(phi0_, kUniformly, random_);
  ASSERT_EQ(q_.action(), 1);
  EXPECT_EQ(q_.action_value(), 0);
  EXPECT_EQ(q_.state_value(), 1);

  // Q(x1) = (0.5, 1, 0). e_V = 1 + 0.9 * 1 - 1 = 0.9, e_Q = 1 + 0.9 * 1 - 0 = 1.9; E was 0.
  Step(1, phi1_);
  ASSERT_EQ(q_.action(), 0);
  EXPECT_EQ(q_.action_value(), 0.5);
  EXPECT_EQ(q_.state_value(), 1);
  ExpectNear(q_.theta(), Rows({{1, 0}, {0.95, 2}, {0, 0}}));
  ExpectNear(q_.traces(), Rows({{0, 0}, {0.45, 0}, {0, 0}}));

  // Q(x2) = (0, 2, 0). e_V = -1 + 1.8 - 1 = -0.2, e_Q = -1 + 1.8 - 0.5 = 0.3.
  // theta_1 += 0.5 * -0.2 * (0.45, 0); theta_0 += 0.5 * 0.3 * (0.5, 0.5).
  Step(-1, phi2_);
  ASSERT_EQ(q_.action(), 1);
  EXPECT_EQ(q_.action_value(), 2);
  ExpectNear(q_.theta(), Rows({{1.075, 0.075}, {0.905, 2}, {0, 0}}));
  ExpectNear(q_.traces(), Rows({{0.225, 0.225}, {0.2025, 0}, {0, 0}}));

  // Q(x3 = x0) = (1.075, 0.905, 0). e_V = e_Q = 0 + 0.9675 - 2 = -1.0325, with the Q and V of the
  // moment of selection. theta_1 += -0.51625 * ((0.2025, 0) + (0, 1)); theta_0 += -0.51625 * 0.225.
  Step(0, phi0_);
  ASSERT_EQ(q_.action(), 2);
  EXPECT_EQ(q_.action_value(), 0);
  EXPECT_EQ(q_.state_value(), 1.075);
  ExpectNear(q_.theta(), Rows({{0.95884375, -0.04115625}, {0.800459375, 1.48375}, {0, 0}}));
  ExpectNear(q_.traces(), Rows({{0.10125, 0.10125}, {0.091125, 0.45}, {0, 0}}));

  // No next value: e_V = 2 - 1.075 = 0.925, e_Q = 2 - 0.
  q_.EndEpisode(2, settings_, kAlpha);
  ExpectNear(q_.theta(), Rows({{1.005671875, 0.005671875}, {0.8426046875, 1.691875}, {1, 0}}));
}

// With x1 = x0 the second selection sees Q(x1) = Q(x0) although the first action's reward would
// have changed it: it is made before that reward is learned from.
TEST_F(ThreeActions, ValuesLagOneUpdate) {
  q_.StartEpisode(phi0_, kUniformly, random_);
  Step(100, phi0_);
  EXPECT_EQ(q_.state_value(), 1);
  EXPECT_GT(q_.theta()(1, 0), 50);
}

TEST_F(ThreeActions, StartOfEpisodeForgetsTheTracesAndKeepsTheta) {
  q_.StartEpisode(phi0_, kUniformly, random_);
  Step(1, phi1_);
  const Matrix theta = q_.theta();
  q_.StartEpisode(phi0_, kUniformly, random_);
  EXPECT_TRUE(q_.traces().isZero(0));
  EXPECT_EQ(q_.theta(), theta);
}

TEST_F(ThreeActions, PassOverWhatWouldNotBeFinite) {
  q_.StartEpisode(phi0_, kUniformly, random_);
  const Matrix theta = q_.theta();
  for (const double reward : {std::numeric_limits<double>::infinity(), std::nan(""), -1e200}) {
    EXPECT_FALSE(q_.Step(reward, settings_, kAlpha, phi1_, kUniformly, random_));
    EXPECT_FALSE(q_.EndEpisode(reward, settings_, kAlpha));
    EXPECT_EQ(q_.theta(), theta);
    EXPECT_TRUE(q_.traces().isZero(0));
  }
  EXPECT_TRUE(q_.Step(1, settings_, kAlpha, phi0_, kUniformly, random_));
  EXPECT_NE(q_.theta(), theta);
}

// Each step makes the error of the next one larger, forever.
TEST(QLambda, ALearnerThatDivergesStaysFinite) {
  const VectorXd phi = Vector2d(1, 1);
  Random random(1);
  QLambda q(1, 2);
  q.StartEpisode(phi, kUniformly, random);
  int passed_over = 0;
  for (int step = 0; step < 2000; ++step) {
    if (!q.Step(1, {}, 100, phi, kUniformly, random)) ++passed_over;
  }
  EXPECT_GT(passed_over, 0);
  EXPECT_TRUE(q.theta().allFinite());
}

// gamma lambda = 0.81: 0.81, then 0.81 * 1.81 = 1.4661, which is cut to 1. Only the upper side is.
TEST(QLambda, TracesAreReplacedAboveTheirLimit) {
  const QLambda::Settings settings{.discount = 0.9, .trace_decay = 0.9, .trace_max = 1};
  Random random(1);
  QLambda q(1, 2);
  const VectorXd features = Vector2d(1, -1);
  q.StartEpisode(features, kGreedily, random);
  q.Step(0, settings, 0.1, features, kGreedily, random);
  ExpectNear(q.traces(), Rows({{0.81, -0.81}}));
  q.Step(0, settings, 0.1, features, kGreedily, random);
  ExpectNear(q.traces(), Rows({{1, -1.4661}}));
}

TEST(QLambda, SelectsTheBestActionWithoutTemperature) {
  Random random(1);
  QLambda q(Rows({{0, 1}, {1, 0}, {0.5, 0.5}}));
  q.StartEpisode(Vector2d(1, 0), kGreedily, random);
  EXPECT_EQ(q.action(), 1);
  q.StartEpisode(Vector2d(0.2, 0.8), kGreedily, random);
  EXPECT_EQ(q.action(), 0);
}

// The same algorithm as its equations say it, over all elements of theta and E.
class DenseQLambda {
 public:
  DenseQLambda(int actions, int features)
      : theta_(actions, std::vector<double>(features)), traces_(theta_) {}

  void StartEpisode() {
    for (auto& row : traces_) std::fill(row.begin(), row.end(), 0.0);
  }

  void Learn(double target, double q, double v, int action, const VectorXd& phi, double alpha,
             const QLambda::Settings& settings) {
    for (size_t a = 0; a < theta_.size(); ++a) {
      for (size_t k = 0; k < theta_[a].size(); ++k) {
        const double gradient = static_cast<int>(a) == action ? phi[k] : 0;
        theta_[a][k] += alpha * (target - v) * traces_[a][k];
        theta_[a][k] += alpha * (target - q) * gradient;
        const double trace = settings.discount * settings.trace_decay * (traces_[a][k] + gradient);
        traces_[a][k] = std::min(trace, settings.trace_max);
      }
    }
  }

  static bool IsBitEqual(const std::vector<std::vector<double>>& rows, const Matrix& matrix) {
    for (size_t a = 0; a < rows.size(); ++a) {
      const double* row = matrix.row(static_cast<Eigen::Index>(a)).data();
      if (std::memcmp(rows[a].data(), row, rows[a].size() * sizeof(double)) != 0) return false;
    }
    return true;
  }

  const std::vector<std::vector<double>>& theta() const { return theta_; }
  const std::vector<std::vector<double>>& traces() const { return traces_; }

 private:
  std::vector<std::vector<double>> theta_;
  std::vector<std::vector<double>> traces_;
};

VectorXd RandomFeatures(int size, Random& random) {
  VectorXd features(size);
  for (double& feature : features) feature = random.Uniform() * random.Uniform();
  return features / features.sum();
}

TEST(QLambda, SparseTracesLearnBitForBitWhatDenseOnesDo) {
  constexpr int kActions = 60, kFeatures = 17;
  const QLambda::Settings settings;
  Random selection(4), world(5);
  QLambda sparse(kActions, kFeatures);
  DenseQLambda dense(kActions, kFeatures);
  for (int episode = 0; episode < 10; ++episode) {
    VectorXd features = RandomFeatures(kFeatures, world);
    sparse.StartEpisode(features, 0.3, selection);
    dense.StartEpisode();
    for (int step = 0; step < 40; ++step) {
      const int action = sparse.action();
      const double q = sparse.action_value(), v = sparse.state_value();
      const double reward = 2 * world.Uniform() - 1;
      const VectorXd next = RandomFeatures(kFeatures, world);
      sparse.Step(reward, settings, 0.3, next, 0.3, selection);
      dense.Learn(reward + settings.discount * sparse.state_value(), q, v, action, features, 0.3,
                  settings);
      features = next;
      ASSERT_TRUE(DenseQLambda::IsBitEqual(dense.theta(), sparse.theta()));
      ASSERT_TRUE(DenseQLambda::IsBitEqual(dense.traces(), sparse.traces()));
    }
  }
  EXPECT_FALSE(sparse.theta().isZero());
}

}  // namespace
}  // namespace runtime
