// Generalized advantage estimation (Schulman et al., "High-dimensional continuous control using
// generalized advantage estimation", 2016):
//
//   delta_t = r_t + gamma v_{t+1} - v_t,   a_t = delta_t + gamma lambda a_{t+1}
#pragma once

#include <span>

namespace runtime {

struct GaeSettings {
  float discount = 0.99f;  // gamma
  float lambda = 0.95f;
};

// Of one episode. `values` has one element more than `rewards`: what the last state is worth, 0
// where it is terminal. Writes one advantage for each reward.
void EstimateAdvantages(std::span<const float> rewards, std::span<const float> values,
                        const GaeSettings& settings, std::span<float> advantages);

}  // namespace runtime
