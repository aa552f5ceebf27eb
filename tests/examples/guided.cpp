// Ng, Harada, Russell: Policy invariance under reward transformations, International Conference on
// Machine Learning (1999): the potential, in place of the published term for coming closer.
#include <Eigen/Dense>

#include "tests/examples/published.h"

namespace examples {
namespace {

class Guided : public Published {
 public:
  void Start(const RobotState& state) override { targets_->Start(state); }

  Payments Step(const RobotState& state, const compiler::Instance& instance) override {
    Payments terms = targets_->Step(state, instance);
    terms.erase("progress");
    return terms;
  }

  Payments Potentials(const RobotState& state, const compiler::Instance& instance) const override {
    const Eigen::Vector2d target(instance.Goal("target", 0), instance.Goal("target", 1));
    return {{"nearer", -120 * (target - state.position.head<2>()).norm()}};
  }

 private:
  const std::unique_ptr<Published> targets_ = IsaacLabTargets();
};

}  // namespace

std::unique_ptr<Published> NgGuided() { return std::make_unique<Guided>(); }

}  // namespace examples
