#include "runtime/training/learning/boltzmann.h"

#include <cassert>

namespace runtime {

void BoltzmannProbabilities(const Eigen::VectorXd& values, double temperature,
                            Eigen::VectorXd& probabilities) {
  assert(values.size() > 0 && values.size() == probabilities.size() && temperature > 0);
  probabilities.array() = ((values.array() - values.maxCoeff()) / temperature).exp();
  const double sum = probabilities.sum();
  constexpr double kVanishing = 1e-300;
  if (sum >= kVanishing) {
    probabilities /= sum;
  } else {  // also if it is not a number
    probabilities.setConstant(1.0 / static_cast<double>(values.size()));
  }
}

int SampleCategorical(const Eigen::VectorXd& probabilities, double uniform) {
  double passed = 0;
  int last_possible = 0;
  for (int action = 0; action < probabilities.size(); ++action) {
    if (probabilities[action] <= 0) continue;
    last_possible = action;
    passed += probabilities[action];
    if (uniform < passed) return action;
  }
  return last_possible;  // the probabilities add up to a little less than 1
}

}  // namespace runtime
