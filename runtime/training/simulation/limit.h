// Forces that have limits: a motor's, a stop's, a contact's.
#pragma once

namespace runtime {

// Pulls a speed toward a target with an impulse of  stiffness * (target - speed),  but no less
// than `low` and no more than `high`.
struct LimitedPull {
  enum class State { kLow, kSpring, kHigh };

  double target = 0;
  double stiffness = 0;
  double low = 0;
  double high = 0;
  State state = State::kSpring;  // assumed; right if NextState() of the speed says the same

  double Wanted(double speed) const { return stiffness * (target - speed); }

  // As long as the state is right, the impulse is  load() - hold() * speed.
  double hold() const { return state == State::kSpring ? stiffness : 0; }
  double load() const {
    return state == State::kSpring ? stiffness * target : state == State::kLow ? low : high;
  }

  double ImpulseAt(double speed) const { return load() - hold() * speed; }

  // The state that a speed asks for; from one limit to the other the way is over the spring. One
  // that is wrong by rounding only is kept.
  State NextState(double speed) const {
    const double wanted = Wanted(speed);
    const double slack = kSlack * stiffness;
    if (state == State::kLow) return wanted > low + slack ? State::kSpring : State::kLow;
    if (state == State::kHigh) return wanted < high - slack ? State::kSpring : State::kHigh;
    if (wanted < low - slack) return State::kLow;
    if (wanted > high + slack) return State::kHigh;
    return State::kSpring;
  }

 private:
  static constexpr double kSlack = 1e-12;  // [m / s] or [rad / s]
};

}  // namespace runtime
