// isaac-sim/IsaacLab: isaaclab_tasks/direct/locomotion/locomotion_env.py and
// isaaclab_tasks/direct/humanoid/humanoid_env.py. Targets near the robot, and what it is worth to
// arrive, are the task's own.
#include <cmath>

#include "tests/examples/published.h"

namespace examples {
namespace {

constexpr double kSimulationTimeStep = 1.0 / 120;
constexpr double kTerminationHeight = 0.145;  // this robot's

// How much of the published time step, two of the simulation's, one of this robot's is.
constexpr double kShare = kTimeStep / (2 * kSimulationTimeStep);

Eigen::Vector3d ToTarget(const Eigen::Vector3d& position, const compiler::Instance& instance) {
  return {instance.Goal("target", 0) - position.x(), instance.Goal("target", 1) - position.y(), 0};
}

double Potential(const Eigen::Vector3d& to_target) {
  return -to_target.norm() / kSimulationTimeStep;
}

class Targets : public Published {
 public:
  void Start(const RobotState& state) override { position_ = state.position; }

  Payments Step(const RobotState& state, const compiler::Instance& instance) override {
    if (state.position.z() < kTerminationHeight) return {{"fall", -1}};
    const Eigen::Vector3d to_target = ToTarget(state.position, instance);
    const Eigen::Matrix3d rotation = state.orientation.toRotationMatrix();
    const double heading = rotation.col(0).dot(to_target.normalized());
    const OfJoints actions = state.torques / Humanoid().controller.max_torque;
    const Payments terms = {
        {"progress", Potential(to_target) - Potential(ToTarget(position_, instance))},
        {"alive", 2 * kShare},
        {"heading", (heading > 0.8 ? 0.5 : 0.5 * heading / 0.8) * kShare},
        {"upright", (rotation(2, 2) > 0.93 ? 0.1 : 0) * kShare},
        {"actions", -0.01 * actions.square().sum() * kShare},
        {"energy", -0.05 * (actions * state.joint_velocities * 0.1).abs().sum() * kShare},
        {"stops", -AtLimit(state.angles) * kShare},
        {"arrival", to_target.norm() < 0.15 ? 50 : 0},
    };
    position_ = state.position;
    return terms;
  }

 private:
  static double AtLimit(const OfJoints& angles) {
    double count = 0;
    for (int i = 0; i < kJoints; ++i) {
      const robot::Joint& joint = Humanoid().joints[static_cast<size_t>(i)];
      count += 2 * (angles[i] - joint.low) / (joint.high - joint.low) - 1 > 0.98 ? 1 : 0;
    }
    return count;
  }

  Eigen::Vector3d position_;
};

}  // namespace

std::unique_ptr<Published> IsaacLabTargets() { return std::make_unique<Targets>(); }

}  // namespace examples
