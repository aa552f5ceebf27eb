#include "runtime/training/learning/gae.h"

#include <cassert>

namespace runtime {

void EstimateAdvantages(std::span<const float> rewards, std::span<const float> values,
                        const GaeSettings& settings, std::span<float> advantages) {
  assert(values.size() == rewards.size() + 1 && advantages.size() == rewards.size());
  float advantage = 0;
  for (size_t t = rewards.size(); t-- > 0;) {
    const float delta = rewards[t] + settings.discount * values[t + 1] - values[t];
    advantage = delta + settings.discount * settings.lambda * advantage;
    advantages[t] = advantage;
  }
}

}  // namespace runtime
