// google-deepmind/dm_control: dm_control/suite/humanoid.py, dm_control/utils/rewards.py. Heights
// and velocities are those of this robot.
#include <cmath>
#include <cstdlib>
#include <limits>

#include "tests/examples/published.h"

namespace examples {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kControlTimeStep = 0.025;
constexpr double kStandHeight = 0.29;
constexpr double kWalkSpeed = 0.5;

enum class Sigmoid { kGaussian, kLinear, kQuadratic };

double SigmoidOf(double x, double value_at_1, Sigmoid sigmoid) {
  switch (sigmoid) {
    case Sigmoid::kGaussian: {
      const double scale = std::sqrt(-2 * std::log(value_at_1));
      return std::exp(-0.5 * std::pow(x * scale, 2));
    }
    case Sigmoid::kLinear: {
      const double scaled = x * (1 - value_at_1);
      return std::abs(scaled) < 1 ? 1 - scaled : 0;
    }
    case Sigmoid::kQuadratic: {
      const double scaled = x * std::sqrt(1 - value_at_1);
      return std::abs(scaled) < 1 ? 1 - scaled * scaled : 0;
    }
  }
  std::abort();
}

struct Tolerance {
  double low = 0;
  double high = 0;
  double margin = 0;
  Sigmoid sigmoid = Sigmoid::kGaussian;
  double value_at_margin = 0.1;

  double operator()(double x) const {
    if (low <= x && x <= high) return 1;
    const double distance = (x < low ? low - x : x - high) / margin;
    return SigmoidOf(distance, value_at_margin, sigmoid);
  }
};

Eigen::Vector2d CenterOfMassVelocity(const RobotState& state) {
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
  double mass = 0;
  for (int i = 0; i < kLinks; ++i) {
    const double mass_of_link = Humanoid().links[static_cast<size_t>(i)].mass;
    momentum += mass_of_link * state.link_velocities.col(i);
    mass += mass_of_link;
  }
  return (momentum / mass).head<2>();
}

double SmallControl(const RobotState& state) {
  const Tolerance small{.margin = 1, .sigmoid = Sigmoid::kQuadratic, .value_at_margin = 0};
  double sum = 0;
  for (const double torque : state.torques) sum += small(torque / Humanoid().controller.max_torque);
  return (4 + sum / kJoints) / 5;
}

double StandReward(const RobotState& state) {
  const Tolerance standing{.low = kStandHeight, .high = kInfinity, .margin = kStandHeight / 4};
  const Tolerance upright{.low = 0.9,
                          .high = kInfinity,
                          .margin = 1.9,
                          .sigmoid = Sigmoid::kLinear,
                          .value_at_margin = 0};
  return standing(state.link_positions(2, LinkOf("head"))) *
         upright(state.orientation.toRotationMatrix()(2, 2));
}

// The published reward is paid in each of the published time steps.
Payments Paid(const std::string& term, double reward) {
  return {{term, reward * kTimeStep / kControlTimeStep}};
}

class Stand : public Published {
 public:
  Payments Step(const RobotState& state, const compiler::Instance&) override {
    const Tolerance still{.margin = 1};
    const Eigen::Vector2d velocity = CenterOfMassVelocity(state);
    const double dont_move = (still(velocity.x()) + still(velocity.y())) / 2;
    return Paid("stand", SmallControl(state) * StandReward(state) * dont_move);
  }
};

class Walk : public Published {
 public:
  Payments Step(const RobotState& state, const compiler::Instance&) override {
    const Tolerance fast{.low = kWalkSpeed,
                         .high = kInfinity,
                         .margin = kWalkSpeed,
                         .sigmoid = Sigmoid::kLinear,
                         .value_at_margin = 0};
    const double move = (5 * fast(CenterOfMassVelocity(state).norm()) + 1) / 6;
    return Paid("walk", SmallControl(state) * StandReward(state) * move);
  }
};

}  // namespace

std::unique_ptr<Published> DmControlStand() { return std::make_unique<Stand>(); }
std::unique_ptr<Published> DmControlWalk() { return std::make_unique<Walk>(); }

}  // namespace examples
