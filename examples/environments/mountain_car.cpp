// A car in a valley, whose motor is too weak for the hill: it has to gain speed on the other side.
#include <cmath>

#include "runtime/core/module/module_library.h"
#include "runtime/training/environment/stepped_environment.h"

namespace {

class MountainCar : public runtime::SteppedEnvironment {
 public:
  // An action is the motor's force [N].
  MountainCar(std::string name, const runtime::Context& context)
      : SteppedEnvironment(
            std::move(name), context, kTimeStep,
            {Eigen::VectorXd::Constant(1, -0.2), Eigen::VectorXd::Constant(1, 0.2)}) {
    AddSensor("car.position", "real", "m", &position_);
    AddSensor("car.velocity", "real", "m/s", &velocity_);
  }

 private:
  static constexpr double kTimeStep = 0.01;  // [s]
  static constexpr double kGravity = 9.8;    // [m/s^2]
  static constexpr double kMass = 0.2;       // [kg]
  static constexpr double kDamping = 0.3;    // [1/s]
  static constexpr double kWall = -1.2;      // [m]

  void Begin(uint64_t) override {
    position_ = -0.5;
    velocity_ = 0;
  }

  void Step(const Eigen::VectorXd& force) override {
    velocity_ +=
        (-kGravity * kMass * std::cos(3 * position_) + force[0] / kMass - kDamping * velocity_) *
        kTimeStep;
    position_ += velocity_ * kTimeStep;
    if (position_ >= kWall) return;
    position_ = kWall;
    velocity_ = 0;
  }

  double position_ = 0;
  double velocity_ = 0;
};

}  // namespace

TASKC_MODULES(types) { types.Add<MountainCar>("MountainCar"); }
