// What is drawn at random in an episode, by whatever module, follows from the run's seed and the
// episode's number alone: so it does not matter what was drawn in other episodes, nor when.
#pragma once

#include <cstdint>

namespace runtime {

// One number of SplitMix64 (G. L. Steele and others, "Fast splittable pseudorandom number
// generators", 2014): its step, and what it makes of a state. States that are near each other have
// numbers that do not look alike.
inline constexpr uint64_t kSplitMixStep = 0x9E3779B97F4A7C15;

inline uint64_t SplitMix(uint64_t state) {
  state = (state ^ (state >> 30)) * 0xBF58476D1CE4E5B9;
  state = (state ^ (state >> 27)) * 0x94D049BB133111EB;
  return state ^ (state >> 31);
}

inline uint64_t EpisodeSeed(uint64_t run_seed, int64_t episode) {
  const uint64_t of_run = SplitMix(run_seed + kSplitMixStep);
  return SplitMix(of_run + static_cast<uint64_t>(episode) + kSplitMixStep);
}

}  // namespace runtime
