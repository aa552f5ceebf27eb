#include "runtime/trainer/train/probe_schedule.h"

#include <algorithm>
#include <cmath>

namespace runtime {
namespace {

constexpr int64_t kFirstRound = 10;  // episodes, which show how long they take
constexpr double kShareOfAll = 1.0 / 3;
constexpr size_t kFewest = 2;  // searches that go on

// Half of those for which there is time, since episodes get longer as motions get better. 0: it is
// not worth another round.
int64_t EpisodesIn(double seconds_left, double seconds_of_episode, int64_t done) {
  const double possible = seconds_left / seconds_of_episode;
  if (possible < 1 + static_cast<double>(done) / 50) return 0;
  return std::max<int64_t>(1, std::llround(possible / 2));
}

}  // namespace

ProbeSchedule::ProbeSchedule(double seconds, size_t searches, bool is_halved)
    : seconds_(seconds), searches_(searches), is_halved_(is_halved) {}

ProbeSchedule::Round ProbeSchedule::First() const { return {kFirstRound, searches_}; }

ProbeSchedule::Round ProbeSchedule::Next(double elapsed, double seconds_of_round, int64_t round,
                                         int64_t done) {
  double seconds_of_episode = seconds_of_round / static_cast<double>(round);
  if (!is_halved_) {
    const int64_t next = EpisodesIn(kShareOfAll * seconds_ - elapsed, seconds_of_episode, done);
    if (next > 0) return {next, searches_};
    const size_t half = std::max((searches_ + 1) / 2, std::min(searches_, kFewest));
    seconds_of_episode *= static_cast<double>(half) / static_cast<double>(searches_);
    searches_ = half;
    is_halved_ = true;
  }
  return {EpisodesIn(seconds_ - elapsed, seconds_of_episode, done), searches_};
}

}  // namespace runtime
