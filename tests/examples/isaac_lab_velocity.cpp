// isaac-sim/IsaacLab, in isaaclab_tasks/manager_based/locomotion/velocity: velocity_env_cfg.py,
// config/g1/*.py, mdp/rewards.py; isaaclab/envs/mdp/rewards.py. Widths of the kernels and times are
// those of this robot.
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/examples/published.h"

namespace examples {
namespace {

constexpr double kForceThreshold = 1;

bool Touches(const RobotState& state, int link) {
  return state.contact_forces.col(link).norm() > kForceThreshold;
}

// Only the turn about the vertical.
Eigen::Quaterniond YawOf(const Eigen::Quaterniond& q) {
  const double yaw =
      std::atan2(2 * (q.w() * q.z() + q.x() * q.y()), 1 - 2 * (q.y() * q.y() + q.z() * q.z()));
  return {std::cos(yaw / 2), 0, 0, std::sin(yaw / 2)};
}

// What the contact sensor counts for one foot.
struct FootTimes {
  double air = 0;
  double contact = 0;

  void Step(bool touches) {
    air = touches ? 0 : air + kTimeStep;
    contact = touches ? contact + kTimeStep : 0;
  }
  bool in_contact() const { return contact > 0; }
  double in_mode() const { return in_contact() ? contact : air; }
};

double JointDeviation(const OfJoints& angles) {
  double sum = 0;
  for (const char* name :
       {"left_hip_roll", "right_hip_roll", "left_shoulder_pitch", "left_shoulder_roll",
        "left_elbow_pitch", "right_shoulder_pitch", "right_shoulder_roll", "right_elbow_pitch"}) {
    const int joint = JointOf(name);
    sum +=
        std::abs(angles[joint] - Humanoid().poses.front().joint_angles[static_cast<size_t>(joint)]);
  }
  return sum;
}

class Velocity : public Published {
 public:
  void Start(const RobotState& state) override {
    targets_ = state.targets;
    times_ = {};
  }

  Payments Step(const RobotState& state, const compiler::Instance& instance) override {
    for (size_t i = 0; i < feet_.size(); ++i) times_[i].Step(Touches(state, feet_[i]));
    const OfJoints actions = (state.targets - rest_) / kActionScale;
    const OfJoints last_actions = (targets_ - rest_) / kActionScale;
    const Eigen::Vector3d velocity = state.orientation.conjugate() * state.velocity;
    const Eigen::Vector3d turning = state.orientation.conjugate() * state.angular_velocity;
    const Eigen::Vector3d gravity = state.orientation.conjugate() * Eigen::Vector3d(0, 0, -1);
    Payments terms = {
        {"tracking", std::exp(-VelocityError(state, instance) / std::pow(0.25, 2))},
        {"turning", std::exp(-std::pow(instance.Goal("turn") - state.angular_velocity.z(), 2))},
        {"stepping", 0.75 * AirTime(instance)},
        {"bobbing", -0.2 * std::pow(velocity.z(), 2)},
        {"swaying", -0.05 * turning.head<2>().squaredNorm()},
        {"leaning", -1.0 * gravity.head<2>().squaredNorm()},
        {"sliding", -0.1 * Slide(state)},
        {"contacts", -1.0 * UndesiredContacts(state)},
        {"deviation", -0.1 * JointDeviation(state.angles)},
        {"torques", -2e-6 * state.torques.square().sum()},
        {"accelerations", -1e-7 * state.joint_accelerations.square().sum()},
        {"actions", -0.005 * (actions - last_actions).square().sum()},
    };
    for (auto& [name, payment] : terms) payment *= kTimeStep;
    // For the published time step.
    if (Touches(state, LinkOf("body")) || Touches(state, LinkOf("head")))
      terms["fall"] = -200 * 0.02;
    targets_ = state.targets;
    return terms;
  }

 private:
  static constexpr double kActionScale = 0.5;

  static Eigen::Vector2d Command(const compiler::Instance& instance) {
    return {instance.Goal("command", 0), instance.Goal("command", 1)};
  }

  static double VelocityError(const RobotState& state, const compiler::Instance& instance) {
    const Eigen::Vector3d velocity = YawOf(state.orientation).conjugate() * state.velocity;
    return (Command(instance) - velocity.head<2>()).squaredNorm();
  }

  double AirTime(const compiler::Instance& instance) const {
    const bool is_single_stance = times_[0].in_contact() != times_[1].in_contact();
    if (!is_single_stance || Command(instance).norm() <= 0.05) return 0;
    return std::min(std::min(times_[0].in_mode(), times_[1].in_mode()), 0.2);
  }

  double Slide(const RobotState& state) const {
    double sum = 0;
    for (const int foot : feet_) {
      if (Touches(state, foot)) sum += state.link_velocities.col(foot).head<2>().norm();
    }
    return sum;
  }

  double UndesiredContacts(const RobotState& state) const {
    double count = 0;
    for (int i = 0; i < kLinks; ++i) {
      const bool may_touch =
          i == LinkOf("body") || i == LinkOf("head") || i == feet_[0] || i == feet_[1];
      if (!may_touch && Touches(state, i)) ++count;
    }
    return count;
  }

  const std::array<int, 2> feet_ = {LinkOf("left_foot"), LinkOf("right_foot")};
  const OfJoints rest_ = Eigen::Map<const OfJoints>(Humanoid().poses.front().joint_angles.data());
  std::array<FootTimes, 2> times_;
  OfJoints targets_;
};

}  // namespace

std::unique_ptr<Published> IsaacLabVelocity() { return std::make_unique<Velocity>(); }

}  // namespace examples
