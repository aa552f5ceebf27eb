#include "runtime/training/learning/observation.h"

#include <utility>

#include "runtime/core/module/connections.h"

namespace runtime {

Observation::Observation(std::string name, const Context& context)
    : Module(std::move(name)),
      robot_(this, *context.robot),
      values_(Eigen::VectorXd::Zero(robot_.size())) {}

void Observation::Start() { RequireConnections(*this); }

const Eigen::VectorXd& Observation::Read() {
  robot_.Compute(values_);
  return values_;
}

}  // namespace runtime
