#include "runtime/trainer/environment/environment_session.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "base/command_line/command.h"
#include "runtime/training/run/episode.h"

namespace runtime {
namespace {

constexpr uint64_t kSeedMask = (uint64_t{1} << 53) - 1;

// The agent with somebody outside in the place of its learner.
ModuleGraph GraphOf(const SharedEnvironment& shared, Outside& outside) {
  const TaskSetup& setup = shared.setup;
  ModuleTypes types = setup.types;
  types.Add(OutsideLearner::kType, [&](std::string name, const Context&) {
    return std::make_unique<OutsideLearner>(std::move(name), outside, shared.discount);
  });
  Agent learner;
  learner.modules = {
      {setup.graph.FindOnly<Learner>().name(), OutsideLearner::kType, {"trainer environment"}, {}}};
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

EnvironmentSession::EnvironmentSession(const SharedEnvironment& shared, LocalSocket socket)
    : shared_(shared),
      messages_(std::move(socket)),
      graph_(GraphOf(shared, *this)),
      environment_(graph_.FindOnly<Environment>()),
      learner_(graph_.FindOnly<OutsideLearner>()),
      tasks_(FindTaskModules(graph_, learner_)) {
  graph_.Start();
}

void EnvironmentSession::Run() {
  try {
    Greet();
    RunEpisodes();
  } catch (const ClientIsGone&) {
    // That is how it ends.
  }
}

void EnvironmentSession::Greet() {
  const Module& source = learner_.FindPort("observation").Connections().front()->owner();
  nlohmann::ordered_json about = {{"taskc_environment", 1},
                                  {"task", shared_.task.task},
                                  {"robot", shared_.setup.robot.name},
                                  {"profile", environment_.profile()},
                                  {"time_step", environment_.time_step()}};
  messages_.Greet(about.dump(), learner_.action_size(),
                  LayoutShownBy(source).value_or(ObservationLayout{}));
}

void EnvironmentSession::RunEpisodes() {
  WaitForReset();
  while (true) {
    try {
      RunEpisode();
      WaitForReset();
    } catch (const IsResetAgain&) {
      learner_.Abandon();
    }
  }
}

void EnvironmentSession::RunEpisode() {
  is_begun_ = false;
  const EpisodeRecord episode =
      runtime::RunEpisode(number_, {environment_, learner_, tasks_}, [](int64_t) {});
  if (is_begun_) {
    messages_.TellEnd(last_observation_, last_reward_, episode, shared_.task);
  } else {
    messages_.TellError(
        fmt::format("the episode ends where it begins: {}", episode.active.end_reason));
  }
}

void EnvironmentSession::NumberEpisode(const ResetRequest& reset) {
  number_ = reset.seed ? static_cast<int64_t>(*reset.seed & kSeedMask) + 1 : number_ + 1;
}

void EnvironmentSession::WaitForReset() {
  while (true) {
    const ClientRequest request = messages_.Wait();
    if (const auto* reset = std::get_if<ResetRequest>(&request)) return NumberEpisode(*reset);
    const auto* foreign = std::get_if<ForeignRequest>(&request);
    messages_.TellError(foreign != nullptr ? foreign->what : "no episode runs: reset first");
  }
}

const Eigen::VectorXd& EnvironmentSession::WaitForStep() {
  while (true) {
    const ClientRequest request = messages_.Wait();
    if (std::holds_alternative<StepRequest>(request)) return messages_.action();
    if (const auto* reset = std::get_if<ResetRequest>(&request)) {
      NumberEpisode(*reset);
      throw IsResetAgain();
    }
    messages_.TellError(std::get<ForeignRequest>(request).what);
  }
}

const Eigen::VectorXd& EnvironmentSession::Begin(const Eigen::VectorXd& observation) {
  messages_.TellStart(observation);
  is_begun_ = true;
  return WaitForStep();
}

const Eigen::VectorXd& EnvironmentSession::Decide(const Eigen::VectorXd& observation,
                                                  double reward) {
  messages_.TellStep(observation, reward, environment_.time());
  return WaitForStep();
}

void EnvironmentSession::End(const Eigen::VectorXd& observation, double reward) {
  last_observation_ = observation;
  last_reward_ = reward;
}

}  // namespace runtime
