// Motion as a beginner's: every 160 ms a new random posture of the humanoid's 5 degrees of freedom,
// approached smoothly, as actions do.
#pragma once

#include <array>
#include <random>
#include <span>

#include "plugins/robot/robot_description.h"

namespace runtime {

inline const robot::RobotDescription& Humanoid() {
  static const robot::RobotDescription robot = robot::ReadRobot(HUMANOID);
  return robot;
}

class RandomMotion {
 public:
  explicit RandomMotion(unsigned seed) : random_(seed) {}

  // The joints' targets of the next time step; those of joints that do not move stay as they
  // are.
  void Next(std::span<double> targets) {
    if (steps_ % kTimeSteps == 0) {
      from_ = now_;
      for (size_t i = 0; i < to_.size(); ++i) {
        to_[i] = std::uniform_real_distribution(net_.low[i], net_.high[i])(random_);
      }
    }
    const double rest = 1 - (steps_ % kTimeSteps) / 60.0;
    for (size_t i = 0; i < to_.size(); ++i) {
      now_[i] = to_[i] - (to_[i] - from_[i]) * rest * rest * rest;
    }
    for (const robot::Coupling& coupling : dof_.couplings) {
      targets[coupling.joint] = coupling.factor * now_[coupling.coordinate];
    }
    ++steps_;
  }

 private:
  static constexpr int kTimeSteps = 32;  // of one posture

  const robot::DofConfiguration& dof_ = *Humanoid().FindDof("5");
  const robot::NetDescription& net_ = *Humanoid().FindNet("bq01");
  std::mt19937 random_;
  std::array<double, 5> from_{}, to_{}, now_{};
  int steps_ = 0;
};

}  // namespace runtime
