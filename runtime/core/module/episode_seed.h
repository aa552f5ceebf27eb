// What is drawn at random in an episode, by whatever module, follows from the run's seed and the
// episode's number alone: so it does not matter what was drawn in other episodes, nor when.
#pragma once

#include <cstdint>

namespace runtime {

// SplitMix64 (G. L. Steele and others, "Fast splittable pseudorandom number generators", 2014): no
// two episodes have seeds that look alike.
inline uint64_t EpisodeSeed(uint64_t run_seed, int64_t episode) {
  const auto mixed = [](uint64_t x) {
    x += 0x9E3779B97F4A7C15;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EB;
    return x ^ (x >> 31);
  };
  return mixed(mixed(run_seed) + static_cast<uint64_t>(episode));
}

}  // namespace runtime
