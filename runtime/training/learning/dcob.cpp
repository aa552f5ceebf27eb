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
    : Module(std::move(name)), robot_(RobotOf(context, this->name())) {
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
  const robot::DofConfiguration& dof = state_in_().dof();
  const GaussianNet& net = net_in_();
  actions_ = DcobActions(name(), interval_parameter_, net.units());
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
  action_count_ = actions_.count();
}

void Dcob::Execute(int action) {
  actions_.CheckAction(name(), action);
  const Eigen::VectorXd& state = state_in_().Read();
  const GaussianNet& net = net_in_();
  const Eigen::VectorXd& features = features_in_();
  DcobActions::CheckFeatures(name(), features.size(), net.units());
  start_ = state.segment(State::kAngles, start_.size());
  target_ = net.centers().row(actions_.UnitOf(action)).transpose();
  motion_.Start(start_, target_, actions_.IntervalOf(action), Distance(state),
                features.dot(net.neighbor_distances()), abbreviation_scale_);
  moving_ = true;
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
