// Siekmann, Godse, Fern, Hurst: Sim-to-Real Learning of All Common Bipedal Gaits via Periodic
// Reward Composition, ICRA (2021), section III: in the swing of a foot the force on it costs, in
// the stance its speed, each as 1 - exp(-x^2). The clock's edges and the widths are the task's own.
#include <cmath>

#include "tests/examples/published.h"

namespace examples {
namespace {

constexpr double kCycle = 0.5;
constexpr double kForceWidth = 4;
constexpr double kSpeedWidth = 0.25;

// From the middle of the cycle's first half, where the foot swings, to that of its second half.
double Swing(double phase) {
  const double from_middle = std::abs(phase - std::floor(phase) - 0.25);
  const double to_edge = 0.25 - (from_middle > 0.5 ? 1 - from_middle : from_middle);
  const double distance = std::abs(to_edge);
  const double blurred = distance < 0.05  ? 0.45 * distance / 0.05
                         : distance < 0.1 ? 0.45 + 0.05 * (distance - 0.05) / 0.05
                                          : 0.5;
  return to_edge > 0 ? 0.5 + blurred : 0.5 - blurred;
}

double Cost(double x) { return 1 - std::exp(-x * x); }

class March : public Published {
 public:
  void Start(const RobotState& state) override { walk_->Start(state); }

  Payments Step(const RobotState& state, const compiler::Instance& instance) override {
    Payments terms = walk_->Step(state, instance);
    const double left = Swing(state.time / kCycle);
    const double right = Swing(state.time / kCycle + 0.5);
    const auto force = [&](const char* foot) {
      return Cost(state.contact_forces.col(LinkOf(foot)).norm() / kForceWidth);
    };
    const auto speed = [&](const char* foot) {
      return Cost(state.link_velocities.col(LinkOf(foot)).norm() / kSpeedWidth);
    };
    terms["pressing"] = -(left * force("left_foot") + right * force("right_foot")) * kTimeStep;
    terms["moving"] =
        -((1 - left) * speed("left_foot") + (1 - right) * speed("right_foot")) * kTimeStep;
    return terms;
  }

 private:
  const std::unique_ptr<Published> walk_ = IsaacLabVelocity();
};

}  // namespace

std::unique_ptr<Published> SiekmannMarch() { return std::make_unique<March>(); }

}  // namespace examples
