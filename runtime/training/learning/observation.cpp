#include "runtime/training/learning/observation.h"

#include <utility>

#include "runtime/core/module/connections.h"

namespace runtime {

Observation::Observation(std::string name, const Context& context)
    : Module(std::move(name)), robot_(this, *context.robot) {}

void Observation::Start() { Layout(); }

// Made when it is first asked for: modules may be started in any order.
const ObservationLayout& Observation::Layout() {
  if (!layout_.values.empty()) return layout_;
  RequireConnections(*this);
  layout_ = task_().observation_layout();
  is_of_task_ = !layout_.values.empty();
  if (!is_of_task_) {
    robot_.RequireSensors();
    layout_ = robot_.layout();
  }
  values_.setZero(static_cast<Eigen::Index>(layout_.size()));
  return layout_;
}

const Eigen::VectorXd& Observation::Read() {
  if (is_of_task_) {
    const std::span<const double> observed = task_().Observe();
    values_ = Eigen::Map<const Eigen::VectorXd>(observed.data(), values_.size());
  } else {
    robot_.Compute(values_);
  }
  return values_;
}

}  // namespace runtime
