#include "runtime/training/learning/box_actions.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "runtime/core/module/connections.h"

namespace runtime {

BoxActions::BoxActions(std::string name, const Context&) : Module(std::move(name)) {
  AddParameter({.name = "hold",
                .doc = "time steps that an action lasts",
                .target = &hold_,
                .minimum = 1,
                .maximum = std::numeric_limits<int>::max()});
}

const int& BoxActions::ActionSize() {
  if (action_size_ == 0) {
    RequireConnections(*this);
    action_size_ = static_cast<int>(limits_().low.size());
    action_.setZero(action_size_);
  }
  return action_size_;
}

void BoxActions::Execute(const Eigen::VectorXd& action) {
  if (action.size() != action_size_) {
    throw UserError(fmt::format(
        "`{}` gets an action of {} elements, and its actions have {}: take their size from it",
        name(), action.size(), action_size_));
  }
  const ActionLimits& limits = limits_();
  action_ = (limits.low + limits.high + (limits.high - limits.low).cwiseProduct(action)) / 2;
  action_ = action_.cwiseMax(limits.low).cwiseMin(limits.high);
  steps_left_ = hold_;
}

void BoxActions::EndOfTimeStep(double) {
  if (steps_left_ == 0 || --steps_left_ > 0) return;
  end_of_action_();  // usually starts the next action
}

}  // namespace runtime
