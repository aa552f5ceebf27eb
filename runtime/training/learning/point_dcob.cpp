#include "runtime/training/learning/point_dcob.h"

#include <fmt/format.h>

#include <utility>

#include "runtime/core/module/connections.h"

namespace runtime {
namespace {

constexpr const char* kDisplacement = "displacement";
constexpr const char* kPosition = "position";

}  // namespace

PointDcob::PointDcob(std::string name, const Context&)
    : Module(std::move(name)), command_(kDisplacement) {
  AddParameter({.name = "intervals",
                .doc = "paces of the motions [s for each unit of the way], each greater than 0",
                .target = &intervals_,
                .minimum = 0,
                .is_live = false});
  AddParameter({.name = "abbreviation_scale",
                .doc = "factor of the time after which a motion is cut short",
                .target = &abbreviation_scale_,
                .minimum = 0});
  AddParameter({"max_norm", "measure the distance to the target by the max norm", &max_norm_});
  AddParameter(
      {.name = "command",
       .doc = "what the environment is told: how far to move in a time step, or where to be",
       .target = &command_,
       .choices = {kDisplacement, kPosition},
       .is_live = false});
}

const int& PointDcob::ActionCount() {
  if (action_count_ == 0) Prepare();
  return action_count_;
}

void PointDcob::Prepare() {
  RequireConnections(*this);
  const GaussianNet& net = net_in_();
  if (limits_().low.size() != net.dimensions()) {
    throw UserError(fmt::format(
        "`{}` gets a net over {} elements, and an action of the environment has {}: what it "
        "observes has to be what moves",
        name(), net.dimensions(), limits_().low.size()));
  }
  actions_ = DcobActions(name(), intervals_, net.units());
  motion_ = DcobMotion(net.dimensions());
  for (Eigen::VectorXd* vector : {&start_, &target_, &action_}) vector->setZero(net.dimensions());
  action_count_ = actions_.count();
}

void PointDcob::Execute(int action) {
  actions_.CheckAction(name(), action);
  const GaussianNet& net = net_in_();
  const Eigen::VectorXd& features = features_in_();
  DcobActions::CheckFeatures(name(), features.size(), net.units());
  start_ = observation_in_();
  target_ = net.centers().row(actions_.UnitOf(action)).transpose();
  action_ = target_ - start_;  // for its length only
  motion_.Start(start_, target_, actions_.IntervalOf(action), Length(action_, NormFrom(max_norm_)),
                features.dot(net.neighbor_distances()), abbreviation_scale_);
  action_.setZero();
  moving_ = true;
}

// As of the moment when the step starts (DcobMotion::Command).
void PointDcob::StartOfTimeStep(double) {
  if (!moving_) return;
  action_ = motion_.Command();
  if (command_ == kDisplacement) action_ -= observation_in_();
}

void PointDcob::EndOfTimeStep(double time_step) {
  if (!moving_ || !motion_.Advance(time_step)) return;
  moving_ = false;
  end_of_action_();  // usually starts the next motion
}

}  // namespace runtime
