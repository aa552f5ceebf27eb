// google-deepmind/mujoco_playground: mujoco_playground/_src/locomotion/go1/getup.py.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/examples/published.h"

namespace examples {
namespace {

constexpr double kDesiredHeight = 0.24;  // this robot's
constexpr double kSoftLimitFactor = 0.95;

double CostOfLimits(const OfJoints& angles) {
  double cost = 0;
  for (int i = 0; i < kJoints; ++i) {
    const robot::Joint& joint = Humanoid().joints[static_cast<size_t>(i)];
    const double center = (joint.low + joint.high) / 2;
    const double range = joint.high - joint.low;
    cost += -std::min(angles[i] - (center - 0.5 * range * kSoftLimitFactor), 0.0);
    cost += std::max(angles[i] - (center + 0.5 * range * kSoftLimitFactor), 0.0);
  }
  return cost;
}

OfJoints DefaultPose() {
  return Eigen::Map<const OfJoints>(Humanoid().poses.front().joint_angles.data());
}

class GetUp : public Published {
 public:
  void Start(const RobotState& state) override {
    angles_ = state.angles;
    // As if the first action had always been taken.
    last_ = before_last_ = (state.targets - angles_) / kActionScale;
  }

  Payments Step(const RobotState& state, const compiler::Instance&) override {
    const OfJoints action = (state.targets - angles_) / kActionScale;
    Payments terms = Rewards(state, action);
    double sum = 0;
    for (auto& [name, payment] : terms) sum += payment *= kTimeStep;
    terms["floor"] = std::max(-sum, 0.0);  // the sum is clipped
    angles_ = state.angles;
    before_last_ = last_;
    last_ = action;
    return terms;
  }

 private:
  static constexpr double kActionScale = 0.5;

  Payments Rewards(const RobotState& state, const OfJoints& action) const {
    const Eigen::Vector3d down(0, 0, -1);
    const Eigen::Vector3d gravity = state.orientation.conjugate() * down;
    const double lean = (down - gravity).squaredNorm();
    const double height = std::min(state.position.z(), kDesiredHeight);
    const bool is_upright = lean < 0.01;
    const bool is_high = kDesiredHeight - height < 0.005;
    const OfJoints too_fast = (state.joint_velocities.abs() - 2 * std::numbers::pi).max(0.0);
    return {
        {"orientation", std::exp(-2.0 * lean)},
        {"height", std::exp(height) - 1},
        {"posture",
         is_upright ? std::exp(-0.5 * (state.angles - DefaultPose()).square().sum()) : 0},
        {"still", is_upright && is_high ? std::exp(-0.5 * action.square().sum()) : 0},
        {"actions", -0.001 * ((action - last_).square().sum() +
                              (action - 2 * last_ + before_last_).square().sum())},
        {"limits", -0.1 * CostOfLimits(state.angles)},
        {"torques", -1e-5 * (std::sqrt(state.torques.square().sum()) + state.torques.abs().sum())},
        {"accelerations", -2.5e-7 * state.joint_accelerations.square().sum()},
        {"velocities", -0.1 * too_fast.square().sum()},
    };
  }

  OfJoints angles_;
  OfJoints last_;
  OfJoints before_last_;
};

}  // namespace

std::unique_ptr<Published> PlaygroundGetUp() { return std::make_unique<GetUp>(); }

}  // namespace examples
