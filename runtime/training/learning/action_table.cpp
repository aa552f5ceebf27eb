#include "runtime/training/learning/action_table.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "runtime/core/module/connections.h"

namespace runtime {

ActionTable::ActionTable(std::string name, const Context&) : Module(std::move(name)) {
  AddParameter({.name = "actions",
                .doc = "the vectors, one after the other",
                .target = &actions_,
                .is_live = false});
  AddParameter({.name = "hold",
                .doc = "time steps that an action lasts",
                .target = &hold_,
                .minimum = 1,
                .maximum = std::numeric_limits<int>::max()});
}

const int& ActionTable::ActionCount() {
  if (action_count_ == 0) Prepare();
  return action_count_;
}

void ActionTable::Prepare() {
  RequireConnections(*this);
  const auto size = static_cast<size_t>(limits_().low.size());
  if (actions_.empty() || actions_.size() % size != 0) {
    throw UserError(fmt::format(
        "`{}.actions` has {} numbers, and an action of the environment has {}: list that many for "
        "each action",
        name(), actions_.size(), size));
  }
  action_.setZero(static_cast<Eigen::Index>(size));
  action_count_ = static_cast<int>(actions_.size() / size);
}

void ActionTable::Execute(int action) {
  if (action < 0 || action >= action_count_) {
    throw UserError(fmt::format("`{}` gets action {} and has {} actions: take their number from it",
                                name(), action, action_count_));
  }
  action_ = Eigen::VectorXd::Map(actions_.data() + action * action_.size(), action_.size());
  steps_left_ = hold_;
}

void ActionTable::EndOfTimeStep(double) {
  if (steps_left_ == 0 || --steps_left_ > 0) return;
  end_of_action_();  // usually starts the next action
}

}  // namespace runtime
