#include "runtime/training/learning/adam.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>

namespace runtime {
namespace {

// The published algorithm, written out for one weight.
class PublishedAdam {
 public:
  double Step(double gradient, double alpha) {
    ++t_;
    m_ = 0.9 * m_ + 0.1 * gradient;
    v_ = 0.999 * v_ + 0.001 * gradient * gradient;
    const double m_hat = m_ / (1 - std::pow(0.9, t_));
    const double v_hat = v_ / (1 - std::pow(0.999, t_));
    return -alpha * m_hat / (std::sqrt(v_hat) + 1e-8);
  }

 private:
  int t_ = 0;
  double m_ = 0;
  double v_ = 0;
};

TEST(Adam, StepsAsPublished) {
  Adam<double> adam(2);
  std::array<PublishedAdam, 2> published;
  Eigen::VectorXd weights{{1, -2}};
  Eigen::VectorXd expected = weights;
  for (const Eigen::Vector2d& gradient :
       {Eigen::Vector2d(0.5, -3), Eigen::Vector2d(-0.1, 2), Eigen::Vector2d(0, 1e-7)}) {
    adam.Step(gradient, 0.01, weights);
    for (int i = 0; i < 2; ++i) expected[i] += published[i].Step(gradient[i], 0.01);
    EXPECT_LT((weights - expected).lpNorm<Eigen::Infinity>(), 1e-15);
  }
}

TEST(Adam, FirstStepIsTheRateWhateverTheGradient) {
  Adam<double> adam(2);
  Eigen::VectorXd weights{{1, 1}};
  adam.Step(Eigen::Vector2d(1e-3, -1e5), 0.01, weights);
  EXPECT_NEAR(weights[0], 0.99, 1e-6);
  EXPECT_NEAR(weights[1], 1.01, 1e-6);
}

TEST(Adam, GoesOnFromWhatWasSaved) {
  const Eigen::VectorXf gradient{{0.5f, -1.f}};
  Adam<float> adam(2);
  Eigen::VectorXf weights{{0, 0}};
  adam.Step(gradient, 0.01f, weights);
  std::stringstream stream;
  adam.Save(stream);
  Adam<float> other(2);
  other.Load(stream);
  Eigen::VectorXf other_weights = weights;
  adam.Step(-gradient, 0.01f, weights);
  other.Step(-gradient, 0.01f, other_weights);
  EXPECT_EQ(weights, other_weights);
  stream.seekg(0);
  Adam<float> larger(3);
  larger.Load(stream);
  EXPECT_TRUE(stream.fail());
}

}  // namespace
}  // namespace runtime
