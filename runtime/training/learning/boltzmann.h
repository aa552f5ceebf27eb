// Exploration: better actions are chosen more often.
#pragma once

#include <Eigen/Core>

namespace runtime {

// p(a) = exp((Q(a) - max Q) / temperature) / Z; all equal where Z is not a number or vanishes.
// `values` and `probabilities` have one element for each action, at least one; `temperature` > 0.
// Allocates nothing.
void BoltzmannProbabilities(const Eigen::VectorXd& values, double temperature,
                            Eigen::VectorXd& probabilities);

// The action at whose place on the wheel the ball comes to rest. `uniform` is in [0, 1). An action
// with probability 0 is never chosen.
int SampleCategorical(const Eigen::VectorXd& probabilities, double uniform);

}  // namespace runtime
