#include "runtime/training/learning/observation.h"

#include <utility>

#include "runtime/base/user_error.h"
#include "runtime/core/module/connections.h"

namespace runtime {
namespace {

const ObservedValue kPhase{
    .name = "phase", .type = "vec2", .unit = "", .size = 2, .minimum = -1, .maximum = 1};

}  // namespace

Observation::Observation(std::string name, const Context& context) : Module(std::move(name)) {
  if (!context.robot->name.empty()) robot_.emplace(this, *context.robot);
}

void Observation::Start() { Layout(); }

// Made when it is first asked for: modules may be started in any order.
const ObservationLayout& Observation::Layout() {
  if (!layout_.values.empty()) return layout_;
  RequireConnections(*this);
  layout_ = task_().observation_layout();
  is_of_task_ = !layout_.values.empty();
  if (!is_of_task_) {
    if (!robot_) {
      throw UserError(
          "the task observes nothing, and names no robot: say what a learner is to see, for "
          "example "
          "`observe car.position`");
    }
    robot_->RequireSensors();
    layout_ = robot_->layout();
    of_robot_.setZero(static_cast<Eigen::Index>(layout_.size()));
  }
  if (phase_.connected()) layout_.values.push_back(kPhase);
  values_.setZero(static_cast<Eigen::Index>(layout_.size()));
  return layout_;
}

const Eigen::VectorXd& Observation::Read() {
  const Eigen::Index phase = phase_.connected() ? static_cast<Eigen::Index>(kPhase.size) : 0;
  const Eigen::Index others = values_.size() - phase;
  if (is_of_task_) {
    values_.head(others) = Eigen::VectorXd::Map(task_().Observe().data(), others);
  } else {
    robot_->Compute(of_robot_);
    values_.head(others) = of_robot_;
  }
  if (phase > 0) values_.tail(phase) = phase_();
  return values_;
}

}  // namespace runtime
