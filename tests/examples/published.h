// The rewards that the tasks say they pay, written anew from where they were published: the
// language and its compiler have no part in this.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "tests/compiler/emit/compiled_task.h"
#include "tests/examples/robot_state.h"

namespace examples {

inline constexpr double kTimeStep = 0.005;  // of this robot [s]
inline constexpr double kDiscount = 0.9;    // of the learner, for one action

// What each term pays in one time step; a term that pays nothing may be left out.
using Payments = std::map<std::string, double>;

// One task's rewards; knows what it needs of the past.
class Published {
 public:
  virtual ~Published() = default;
  // Makes a random state one in which the task's conditions hold now and then.
  virtual void Adapt(RobotState& state) const { (void)state; }
  virtual void Start(const RobotState& state) { (void)state; }
  virtual void StartAction() {}
  // `instance` is asked for goals only.
  virtual Payments Step(const RobotState& state, const compiler::Instance& instance) = 0;
  // Of the terms that are potentials, what they are in this state.
  virtual Payments Potentials(const RobotState& state, const compiler::Instance& instance) const {
    (void)state, (void)instance;
    return {};
  }
};

std::unique_ptr<Published> DeepMimicTrack();
std::unique_ptr<Published> DmControlStand();
std::unique_ptr<Published> DmControlWalk();
std::unique_ptr<Published> PlaygroundGetUp();
std::unique_ptr<Published> IsaacLabTargets();
std::unique_ptr<Published> NgGuided();
std::unique_ptr<Published> OwnFollow();
std::unique_ptr<Published> OwnTrackSpeed();
std::unique_ptr<Published> IsaacLabVelocity();
std::unique_ptr<Published> OwnLeap();
std::unique_ptr<Published> OwnPressUp();
std::unique_ptr<Published> SiekmannMarch();

}  // namespace examples
