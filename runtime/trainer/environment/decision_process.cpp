#include "runtime/trainer/environment/decision_process.h"

#include <fmt/format.h>

#include <cassert>
#include <memory>
#include <utility>

#include "base/command_line/command.h"
#include "runtime/core/module/live_parameter.h"
#include "runtime/training/run/episode.h"

namespace runtime {
namespace {

// The agent with somebody outside in the place of its learner.
ModuleGraph OutsideGraph(const TaskSetup& setup, double discount) {
  ModuleTypes types = setup.types;
  types.Add(OutsideLearner::kType, [&](std::string name, const Context&) {
    return std::make_unique<OutsideLearner>(std::move(name), discount);
  });
  Agent learner;
  learner.modules = {{setup.graph.FindOnly<Learner>().name(),
                      OutsideLearner::kType,
                      {"in the place of the agent's learner"},
                      {}}};
  return BuildGraph(Changed(setup.agent, learner), types, setup.context);
}

bool HasIn(const Module& module, const char* name, const PortType& type) {
  for (const Port* port : module.ports()) {
    if (port->name() == name) return port->type() == type;
  }
  return false;
}

}  // namespace

void CheckCanBeOutside(const TaskSetup& setup) {
  const auto& learner = setup.graph.FindOnly<Learner>();
  if (HasIn(learner, "observation", MakeValueType<Eigen::VectorXd>("")) &&
      HasIn(learner, "action_size", MakeValueType<int>(""))) {
    return;
  }
  throw command_line::CallError(fmt::format(
      "nobody else can decide in the place of `{}`, a {}: that takes a learner that sees an "
      "observation and decides on vectors; try `--agent ppo`",
      learner.name(), learner.type()));
}

DecisionProcess::DecisionProcess(const TaskSetup& setup, double discount)
    : graph_(OutsideGraph(setup, discount)),
      environment_(graph_.FindOnly<Environment>()),
      learner_(graph_.FindOnly<OutsideLearner>()),
      tasks_(FindTaskModules(graph_, learner_)) {
  graph_.Start();
}

ObservationLayout DecisionProcess::observation_layout() const {
  const Module& source = learner_.observation_port().Connections().front()->owner();
  return LayoutShownBy(source).value_or(ObservationLayout{});
}

void DecisionProcess::Reset(int64_t number) {
  is_running_ = false;
  learner_.Abandon();
  number_ = number;
  steps_ = 0;
  StartEpisode(number, {environment_, learner_, tasks_});
  EndIfOver();
}

void DecisionProcess::Step(const Eigen::VectorXd& action) {
  assert(is_running_);
  is_running_ = false;
  learner_.Decide(action);
  while (!learner_.is_asked() && !learner_.episode_over()) {
    environment_.RunTimeStep();
    ++steps_;
  }
  EndIfOver();
}

void DecisionProcess::Set(const std::string& parameter, const ParameterValue& value) {
  SetLive(graph_, parameter, value);
}

ParameterValue DecisionProcess::Get(const std::string& parameter) const {
  const auto [module, found] = FindParameter(graph_, parameter);
  return module.Get(found.name);
}

void DecisionProcess::EndIfOver() {
  is_running_ = !learner_.episode_over();
  if (is_running_) return;
  record_ = RecordOfEpisode(number_, steps_, {environment_, learner_, tasks_});
  end_kind_ = learner_.episode_end().kind;
}

}  // namespace runtime
