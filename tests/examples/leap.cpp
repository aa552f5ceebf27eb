// What examples/tasks/leap.task says in words: nobody has published it.
#include <cmath>

#include "tests/examples/published.h"

namespace examples {
namespace {

constexpr double kLow = 0.2;
constexpr double kSlow = 0.1;
constexpr double kRest = 0.3;
constexpr double kPatience = 2;

bool IsFoot(const robot::Link& link) { return link.name.ends_with("foot"); }

// How many of the links touch the ground.
int CountOf(const RobotState& state, bool feet) {
  int count = 0;
  for (const robot::Link& link : Humanoid().links)
    if (IsFoot(link) == feet && state.Touches(LinkOf(link.name))) ++count;
  return count;
}

class Leap : public Published {
 public:
  // Mostly slow and on the feet: the last number is as random as all others, and used for nothing
  // else.
  void Adapt(RobotState& state) const override {
    const double chance = std::abs(state.targets[kJoints - 1]) / 0.5;
    if (chance > 0.05) state.velocity *= 0.1;
    if (chance < 0.99)
      for (const robot::Link& link : Humanoid().links)
        if (!IsFoot(link)) state.contact_forces.col(LinkOf(link.name)).setZero();
  }

  void Start(const RobotState&) override {
    phase_ = kBend;
    time_ = 0;
  }

  Payments Step(const RobotState& state, const compiler::Instance&) override {
    Payments terms;
    terms["effort"] = -0.02 * state.torques.square().sum() * kTimeStep;
    if (CountOf(state, false) > 0) terms["fall"] = -5;
    time_ += kTimeStep;
    const Phase next = StepOfPhase(state, terms);
    if (next != phase_) time_ = 0;
    phase_ = next;
    return terms;
  }

  Payments Potentials(const RobotState& state, const compiler::Instance&) const override {
    const double up = (state.position.z() - kLow) / 0.1;
    return {{"way", phase_ == kBend ? -up : up}};
  }

 private:
  enum Phase { kBend, kPush, kFly, kLand };

  // Gives the phase that comes next.
  Phase StepOfPhase(const RobotState& state, Payments& terms) {
    const int feet = CountOf(state, true);
    const bool is_late = time_ > kPatience - kTimeStep / 2;
    switch (phase_) {
      case kBend:
        return state.position.z() < kLow && feet == 2 ? kPush : kBend;
      case kPush:
        if (feet > 0 || CountOf(state, false) > 0) return is_late ? kBend : kPush;
        return kFly;
      case kFly:
        terms["flight"] = 20 * state.velocity.x() * kTimeStep;
        return feet > 0 ? kLand : kFly;
      case kLand:
        break;
    }
    terms["motion"] = -state.velocity.norm() / kSlow * kTimeStep;
    if (state.velocity.norm() < kSlow && time_ > kRest) {
      terms["landing"] = 5;
      return kBend;
    }
    return is_late ? kBend : kLand;
  }

  Phase phase_ = kBend;
  double time_ = 0;  // that it has lasted
};

}  // namespace

std::unique_ptr<Published> OwnLeap() { return std::make_unique<Leap>(); }

}  // namespace examples
