#include "runtime/training/environment/stepped_environment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/core/module/episode_seed.h"

namespace runtime {
namespace {

constexpr const char* kBool = "bool";
constexpr const char* kInt = "int";

}  // namespace

SteppedEnvironment::SteppedEnvironment(std::string name, const Context& context)
    : Environment(std::move(name)), run_seed_(context.seed) {
  AddSensor("time", "real", "s", &time_);
}

SteppedEnvironment::SteppedEnvironment(std::string name, const Context& context, double time_step,
                                       ActionLimits limits)
    : SteppedEnvironment(std::move(name), context) {
  SetSteps(time_step, std::move(limits));
}

void SteppedEnvironment::SetSteps(double time_step, ActionLimits limits) {
  if (!(time_step > 0) || !std::isfinite(time_step)) {
    throw UserError(
        fmt::format("the time step of `{}` is {} s: it must be above 0", name(), time_step));
  }
  const bool are_limits = limits.low.size() == limits.high.size() && limits.low.size() > 0 &&
                          limits.low.allFinite() && limits.high.allFinite() &&
                          (limits.low.array() <= limits.high.array()).all();
  if (!are_limits) {
    throw UserError(fmt::format(
        "the action limits of `{}` are none: each element of an action needs a lower and an upper "
        "one that is not below it, both finite",
        name()));
  }
  time_step_ = time_step;
  limits_ = std::move(limits);
  action_ = Eigen::VectorXd::Zero(limits_.low.size()).cwiseMax(limits_.low).cwiseMin(limits_.high);
}

void SteppedEnvironment::AddSensor(const std::string& name, const std::string& type,
                                   const std::string& unit, const double* elements) {
  OfferSensor(name, type, unit, "", elements);
}

void SteppedEnvironment::AddSensor(const std::string& name, const std::string& type,
                                   const std::string& unit, const bool* elements) {
  OfferSensor(name, type, unit, kBool, elements);
}

void SteppedEnvironment::AddSensor(const std::string& name, const std::string& type,
                                   const std::string& unit, const long long* elements) {
  OfferSensor(name, type, unit, kInt, elements);
}

void SteppedEnvironment::OfferSensor(const std::string& name, const std::string& type,
                                     const std::string& unit, const std::string& kind,
                                     const void* elements) {
  const std::string element = type.substr(0, type.find('['));
  const bool is_special = element == kBool || element == kInt;
  if (kind != (is_special ? element : "")) {
    throw UserError(
        fmt::format("`{}` offers the sensor `{}` as a `{}`, and its elements are of "
                    "another type: bools for a `bool`, long longs for an `int`, "
                    "doubles for all others",
                    this->name(), name, type));
  }
  sensors_.emplace_back(this, name, SensorTypeText(type, unit), elements);
}

void SteppedEnvironment::Start() { Prepare(); }

const ActionLimits& SteppedEnvironment::Limits() {
  Prepare();
  return limits_;
}

void SteppedEnvironment::EndEpisode(EndKind kind, const char* reason) {
  if (is_over_) return;
  is_over_ = true;
  end_ = {kind, reason};
}

void SteppedEnvironment::BeginEpisode(const StartDraw&) {
  steps_ = 0;
  time_ = 0;
  is_started_ = true;
  is_over_ = false;
  end_is_told_ = false;
  Begin(EpisodeSeed(run_seed_, episode()));
  start_of_episode_();
}

void SteppedEnvironment::RunTimeStep() {
  if (!is_started_) return;
  start_of_time_step_(time_step_);
  start_of_physics_step_(time_step_);
  ReadAction();
  if (!is_over_) Step(action_);
  // Counted, not summed, so that 2000 steps of 0.01 s are 20 s and not a little more.
  time_ = static_cast<double>(++steps_) * time_step_;
  end_of_physics_step_(time_step_);
  end_of_time_step_(time_step_);
  if (!is_over_ || end_is_told_) return;
  end_is_told_ = true;
  is_started_ = end_.kind != EndKind::kDiverged;
  end_of_episode_(end_);
}

void SteppedEnvironment::ReadAction() {
  if (!action_in_.connected()) return;
  const Eigen::VectorXd& action = action_in_();
  if (action.size() != action_.size()) {
    throw UserError(fmt::format("`{}` gets an action of {} elements, and its actions have {}",
                                name(), action.size(), action_.size()));
  }
  for (Eigen::Index i = 0; i < action.size(); ++i) {
    // Only a learner that has diverged wants something else than a number.
    const double wanted = std::isfinite(action[i]) ? action[i] : 0;
    action_[i] = std::clamp(wanted, limits_.low[i], limits_.high[i]);
  }
}

}  // namespace runtime
