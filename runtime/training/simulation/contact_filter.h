// Low-pass filters for the contacts of the links, which chatter from one physics step to the next.
#pragma once

#include <span>
#include <vector>

namespace runtime {

// One second-order filter (10 Hz, Q = 0.8) for each link; its flag is set while the output exceeds
// 0.1:
//   t = raw - v2 - v1 / Q;  v1 += a t;  v2 += a v1;  flag = v2 > 0.1;  a = 1 - exp(-2 pi f h)
// A touch shows after 8.0 ms, its end after 38.6 ms, whatever the length of a physics step: within
// a long one the filter takes several steps of its own.
class ContactFilter {
 public:
  ContactFilter(int links, double time_step);

  // As if the contacts had been like that for long.
  void Start(std::span<const unsigned char> raw);
  // One physics step.
  void Update(std::span<const unsigned char> raw);

  bool flag(int link) const { return states_[link].v2 > kThreshold; }

 private:
  static constexpr double kThreshold = 0.1;

  struct State {
    double v1 = 0;
    double v2 = 0;
  };
  void Advance(State& state, double raw) const;

  int substeps_;
  double gain_;  // a
  std::vector<State> states_;
};

}  // namespace runtime
