// What examples/tasks/press_up.task says in words: nobody has published it.
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/examples/published.h"

namespace examples {
namespace {

constexpr double kHighest = 0.09;
constexpr double kLowest = 0.05;
constexpr double kLongest = 3;

// Only hands and feet on the ground.
bool StandsOnSupports(const RobotState& state) {
  for (const robot::Link& link : Humanoid().links) {
    const bool is_support = link.name.ends_with("hand") || link.name.ends_with("foot");
    if (!is_support && state.Touches(LinkOf(link.name))) return false;
  }
  return true;
}

double Straightness(const RobotState& state) {
  double sum = 0;
  for (const char* joint :
       {"left_hip_pitch", "right_hip_pitch", "left_knee_pitch", "right_knee_pitch"}) {
    sum += std::pow(state.angles[JointOf(joint)], 2);
  }
  const double bend = std::sqrt(sum);
  return std::exp(-bend * bend / 0.25);
}

double FartherHand(const RobotState& state) {
  double farther = 0;
  for (const char* side : {"left", "right"}) {
    const std::string name = side;
    const Eigen::Vector3d way = state.link_positions.col(LinkOf(name + "_hand")) -
                                state.link_positions.col(LinkOf(name + "_shoulder"));
    farther = std::max(farther, way.head<2>().norm());
  }
  return farther;
}

class PressUp : public Published {
 public:
  // Low, on the belly, and often with the hands where they belong.
  void Adapt(RobotState& state) const override {
    state.position.z() -= 0.11;
    state.orientation = state.orientation * Eigen::AngleAxisd(1.4, Eigen::Vector3d::UnitY());
    state.link_positions *= 0.2;
    for (const char* side : {"left", "right"}) {
      const std::string name = side;
      state.contact_forces.col(LinkOf(name + "_hand")) =
          state.contact_forces.col(LinkOf("left_foot"));
    }
  }

  void Start(const RobotState&) override {
    phase_ = kLying;
    time_ = 0;
  }

  Payments Step(const RobotState& state, const compiler::Instance&) override {
    Payments terms;
    terms["effort"] = -0.02 * state.torques.square().sum() * kTimeStep;
    const Eigen::Vector3d forward = state.orientation * Eigen::Vector3d::UnitX();
    if (forward.z() > 0.3) terms["turn"] = -5;
    const double height = state.position.z();
    time_ += kTimeStep;
    Phase next = phase_;
    switch (phase_) {
      case kLying:
        terms["hands"] = -FartherHand(state) / 0.1 * kTimeStep;
        if (state.Touches(LinkOf("left_hand")) && state.Touches(LinkOf("right_hand")) &&
            FartherHand(state) < 0.06)
          next = kUp;
        break;
      case kUp:
      case kDown:
        terms["straight"] = 0.5 * Straightness(state) * kTimeStep;
        if (time_ > kLongest - kTimeStep / 2) next = kLying;
        if (phase_ == kUp && height > kHighest && StandsOnSupports(state)) next = kDown;
        if (phase_ == kDown && height < kLowest && StandsOnSupports(state)) {
          terms["press"] = 10;
          next = kUp;
        }
        break;
    }
    if (next != phase_) time_ = 0;
    phase_ = next;
    return terms;
  }

  Payments Potentials(const RobotState& state, const compiler::Instance&) const override {
    const double up = state.position.z() - kLowest;
    const double gone = phase_ == kDown ? 2 * (kHighest - kLowest) - up : up;
    return {{"way", 2 * gone / (kHighest - kLowest)}};
  }

 private:
  enum Phase { kLying, kUp, kDown };
  Phase phase_ = kLying;
  double time_ = 0;  // that it has lasted
};

}  // namespace

std::unique_ptr<Published> OwnPressUp() { return std::make_unique<PressUp>(); }

}  // namespace examples
