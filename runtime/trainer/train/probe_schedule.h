// How the time of a probe is shared among its searches.
#pragma once

#include <cstddef>
#include <cstdint>

namespace runtime {

// All searches go on for a third of the time, and then the better half of them: what a search finds
// depends most on how long it goes on. They do so in rounds, each of as many episodes for each of
// them, since how long episodes take shows only then.
class ProbeSchedule {
 public:
  struct Round {
    int64_t episodes = 0;  // of each search; 0: the time is up
    size_t searches = 0;   // that go on, the best ones
  };

  // `seconds`: how long the probe is to take. `is_halved`: the weaker searches were given up
  // before.
  ProbeSchedule(double seconds, size_t searches, bool is_halved);

  Round First() const;
  // After a round of `round` episodes that took `seconds_of_round`; `elapsed`: since the beginning,
  // `done`: episodes that each of the searches that go on has.
  Round Next(double elapsed, double seconds_of_round, int64_t round, int64_t done);

 private:
  double seconds_;
  size_t searches_;
  bool is_halved_;
};

}  // namespace runtime
