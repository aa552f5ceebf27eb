// Tells a simulation that has gone astray from one of a robot.
#pragma once

#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/training/simulation/joint_controller.h"
#include "runtime/training/simulation/link_motion.h"
#include "runtime/training/simulation/robot_body.h"

namespace runtime {

// Gravity, contacts and stops give a robot no energy; only its motors do, and in a step each gives
// at most its largest torque times the angle that its joint moves by. What appears beyond that
// comes from the steps' length: limbs that have been driven into each other, or turn by a large
// part of a circle in one step. No sound step has any, so all of an episode may be added up.
class Soundness {
 public:
  // An episode ends when what has appeared from nothing could lift the robot by this [m].
  static constexpr double kMostLift = 0.05;
  // ... or when a joint is beyond a stop by this [rad]. Stops are soft; see docs/simulation.md.
  static constexpr double kFarthestPastStop = 0.5;

  // `robot` and `body` outlive the object.
  Soundness(const robot::RobotDescription& robot, const RobotBody& body, double gravity,
            double time_step);

  // Looks at the motion since the call before, which was a physics step ago. `controller` has read
  // the joints since. Throws OdeFailure where there is no sense in going on.
  void Check(const JointController& controller);
  // What has happened to the motion since the last call is no step's work.
  void Restart() { is_first_ = true; }

 private:
  // Of all motions and heights, and of what the joints hold themselves [J].
  double Energy(const JointController& controller) const;
  double EnergyOf(const robot::PassiveForces& forces, double angle, double rate) const;
  // The most that the motors can have given since the last call [J].
  double MostWork(const JointController& controller);
  void CheckStops(const JointController& controller) const;

  const robot::RobotDescription& robot_;
  const RobotBody& body_;
  double gravity_;
  std::vector<double> largest_impulses_;  // of the motors in a step [N m s]
  double limit_;                          // [J]
  std::vector<LinkInertia> masses_;
  std::vector<double> rates_;  // of the joints, the call before [rad/s]
  double energy_ = 0;          // the call before
  double from_nothing_ = 0;    // so far [J]
  bool is_first_ = true;
};

}  // namespace runtime
