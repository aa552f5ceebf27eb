#include "runtime/training/learning/dcob.h"

#include <fmt/format.h>

#include <utility>

#include "runtime/core/module/connections.h"

namespace runtime {
namespace {

constexpr const char* kAngles = "angles";
constexpr const char* kState = "state";

}  // namespace

Dcob::Dcob(std::string name, const Context& context)
    : Module(std::move(name)), robot_(*context.robot) {
  AddParameter({.name = "intervals",
                .doc = "paces of the motions [s/rad], each greater than 0",
                .target = &interval_parameter_,
                .minimum = 0,
                .is_live = false});
  AddParameter({.name = "abbreviation_scale",
                .doc = "factor of the time after which a motion is cut short",
                .target = &abbreviation_scale_,
                .minimum = 0});
  AddParameter({"max_norm", "measure the distance to the target by the max norm", &max_norm_});
  AddParameter({"target",
                "what the distance to the target is measured over",
                &target_parameter_,
                {kAngles, kState}});
}

void Dcob::Start() { ActionCount(); }

const int& Dcob::ActionCount() {
  if (action_count_ == 0) Prepare();
  return action_count_;
}

void Dcob::Prepare() {
  RequireConnections(*this);
  if (interval_parameter_.empty()) {
    throw UserError(fmt::format("`{}.intervals` is empty: it needs at least one number", name()));
  }
  for (const double interval : interval_parameter_) {
    if (interval > 0) continue;
    throw UserError(
        fmt::format("`{}.intervals` must be greater than 0, and {} is not", name(), interval));
  }
  const robot::DofConfiguration& dof = state_in_().dof();
  const GaussianNet& net = net_in_();
  if (net.dimensions() != dof.dof()) {
    throw UserError(
        fmt::format("`{}` gets a net over {} coordinates and a state with {}: take both from the "
                    "same DoF configuration",
                    name(), net.dimensions(), dof.dof()));
  }
  mapping_ = DofMapping(dof, static_cast<int>(robot_.joints.size()));
  motion_ = DcobMotion(dof.dof());
  start_.setZero(dof.dof());
  target_.setZero(dof.dof());
  difference_.setZero(State::Size(dof.dof()));
  joint_targets_.setZero(mapping_.joints());
  intervals_ = interval_parameter_;
  action_count_ = static_cast<int>(intervals_.size()) * net.units();
}

void Dcob::Execute(int action) {
  if (action < 0 || action >= action_count_) {
    throw UserError(fmt::format("`{}` gets action {} and has {} actions: take their number from it",
                                name(), action, action_count_));
  }
  const auto paces = static_cast<int>(intervals_.size());
  const Eigen::VectorXd& state = state_in_().Read();
  const GaussianNet& net = net_in_();
  const Eigen::VectorXd& features = features_in_();
  if (features.size() != net.units()) ThrowForeignFeatures();
  start_ = state.segment(State::kAngles, start_.size());
  target_ = net.centers().row(action / paces).transpose();
  motion_.Start(start_, target_, intervals_[action % paces], Distance(state),
                features.dot(net.neighbor_distances()), abbreviation_scale_);
  moving_ = true;
}

void Dcob::ThrowForeignFeatures() const {
  throw UserError(
      fmt::format("`{}` gets {} features and a net of {} units: take both from the same module",
                  name(), features_in_().size(), net_in_().units()));
}

double Dcob::Distance(const Eigen::VectorXd& state) {
  if (target_parameter_ == kAngles) {
    difference_.head(start_.size()) = target_ - start_;
    return Length(difference_.head(start_.size()), NormFrom(max_norm_));
  }
  difference_ = -state;
  difference_.segment(State::kAngles, target_.size()) += target_;
  return Length(difference_, NormFrom(max_norm_));
}

void Dcob::StartOfTimeStep(double) {
  if (moving_) mapping_.Apply(motion_.Command(), joint_targets_);
}

void Dcob::EndOfTimeStep(double time_step) {
  if (!moving_ || !motion_.Advance(time_step)) return;
  moving_ = false;
  end_of_action_();  // usually starts the next motion
}

}  // namespace runtime
