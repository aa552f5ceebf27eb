#include "runtime/training/simulation/contact_filter.h"

#include <cmath>
#include <numbers>

namespace runtime {
namespace {

constexpr double kFrequency = 10;  // Hz
constexpr double kQuality = 0.8;
constexpr double kLongestTimeStep = 0.0002;  // s
constexpr int kStepsToSettle = 1000;

}  // namespace

ContactFilter::ContactFilter(int links, double time_step)
    : substeps_(static_cast<int>(std::ceil(time_step / kLongestTimeStep * (1 - 1e-9)))),
      gain_(1 - std::exp(-2 * std::numbers::pi * kFrequency * time_step / substeps_)),
      states_(links) {}

void ContactFilter::Start(std::span<const unsigned char> raw) {
  for (size_t i = 0; i < states_.size(); ++i) {
    states_[i] = {};
    for (int n = 0; n < kStepsToSettle; ++n) Advance(states_[i], raw[i]);
  }
}

void ContactFilter::Update(std::span<const unsigned char> raw) {
  for (size_t i = 0; i < states_.size(); ++i) {
    const bool at_rest = raw[i] == 0 && states_[i].v1 == 0 && states_[i].v2 == 0;
    if (at_rest) continue;  // would stay so: many links never touch the ground
    for (int n = 0; n < substeps_; ++n) Advance(states_[i], raw[i]);
  }
}

void ContactFilter::Advance(State& state, double raw) const {
  const double t = raw - state.v2 - state.v1 / kQuality;
  state.v1 += gain_ * t;
  state.v2 += gain_ * state.v1;
}

}  // namespace runtime
