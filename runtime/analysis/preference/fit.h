// The weights that explain best what a user prefers.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "runtime/analysis/preference/preference_model.h"

namespace runtime {

struct Fit {
  Eigen::VectorXd x;           // logarithms of the weights' ratios, new to recorded
  Eigen::MatrixXd covariance;  // of x
};

// The most probable weights within their bounds. Deterministic.
Fit FitWeights(const PreferenceModel& model);

// Whether each comparison holds, to a hundredth of a scale, under the weights within their bounds
// that make the sum of what is wrong as small as it can be, however far they are from the recorded
// ones.
std::vector<bool> HoldAtBest(const PreferenceModel& model);

// How much, in nats, the user's answer about two behaviors would tell of the weights.
double ExpectedInformation(const PreferenceModel& model, const Fit& fit,
                           const Eigen::VectorXd& difference);

}  // namespace runtime
