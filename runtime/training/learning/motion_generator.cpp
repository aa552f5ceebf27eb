#include "runtime/training/learning/motion_generator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace runtime {

MotionGenerator::MotionGenerator(std::string name, const Context& context)
    : MotionModule(std::move(name), context) {
  AddParameter({.name = "parameters",
                .doc = "of the motion, each from -1 to 1, as a motion search finds them",
                .target = &parameters_,
                .minimum = -1,
                .maximum = 1,
                .is_live = false});
}

void MotionGenerator::Start() {
  MotionModule::Start();
  if (parameters_.size() != static_cast<size_t>(motion().size())) {
    throw UserError(fmt::format(
        "`{}.parameters` are {} numbers, and a motion like this has {}: `trainer export RUN "
        "--motion FILE.toml` writes an agent with those that a motion search has found",
        name(), parameters_.size(), motion().size()));
  }
  taken_ = Eigen::VectorXd::Map(parameters_.data(), motion().size());
}

void MotionGenerator::StartOfEpisode() {
  BeginEpisode();
  motion().Take(taken_);
  SetPhase(0);
}

void MotionGenerator::StartOfTimeStep(double time_step) { Move(time_step); }

// After the time step, when a policy decides.
void MotionGenerator::EndOfTimeStep(double time_step) {
  CountTimeStep();
  SetPhase(TimeAt(time_step));
}

void MotionGenerator::SetPhase(double time) {
  const double turns = motion().frequency() * time;
  const bool is_periodic = settings().kind == ParametricMotion::kPeriodic;
  const double angle = std::numbers::pi * (is_periodic ? 2 * turns : std::min(turns, 1.0));
  phase_[0] = std::cos(angle);
  phase_[1] = std::sin(angle);
}

}  // namespace runtime
