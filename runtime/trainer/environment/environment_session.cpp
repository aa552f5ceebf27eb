#include "runtime/trainer/environment/environment_session.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "runtime/training/environment/socket_messages.h"

namespace runtime {
namespace {

// What the task's own sensors are told comes behind its params, and is not among them.
std::vector<OfferedParam> ParamsOf(const UniversalTask& task) {
  std::vector<OfferedParam> params;
  for (const Parameter& param : std::span(task.parameters()).first(task.plugin().param_count)) {
    params.push_back({fmt::format("{}.{}", task.name(), param.name), param.unit, param.minimum,
                      param.maximum, task.Get(param.name)});
  }
  return params;
}

}  // namespace

EnvironmentSession::EnvironmentSession(const SharedEnvironment& shared, LocalSocket socket)
    : shared_(shared), messages_(std::move(socket)), process_(shared.setup, shared.discount) {}

void EnvironmentSession::Run() {
  try {
    Greet();
    while (true) std::visit([this](const auto& each) { Answer(each); }, messages_.Wait());
  } catch (const ClientIsGone&) {
    // That is how it ends.
  }
}

void EnvironmentSession::Greet() {
  const Environment& environment = process_.environment();
  nlohmann::ordered_json about = {{"taskc_environment", kSocketVersion},
                                  {"task", shared_.task.task},
                                  {"robot", shared_.setup.robot.name},
                                  {"profile", environment.profile()},
                                  {"time_step", environment.time_step()}};
  messages_.Greet(about.dump(), process_.action_size(), process_.observation_layout(),
                  ParamsOf(process_.task()));
}

void EnvironmentSession::Answer(const ResetRequest& request) {
  process_.Reset(request.seed ? DecisionProcess::NumberOf(*request.seed) : process_.number() + 1);
  if (process_.is_running()) return messages_.TellStart(process_.observation());
  messages_.TellError(
      fmt::format("the episode ends where it begins: {}", process_.record().active.end_reason));
}

void EnvironmentSession::Answer(const StepRequest&) {
  if (!process_.is_running()) return messages_.TellError("no episode runs: reset first");
  process_.Step(messages_.action());
  if (process_.is_running()) {
    return messages_.TellStep(process_.observation(), process_.reward(),
                              process_.environment().time());
  }
  messages_.TellEnd(process_.observation(), process_.reward(), process_.record(), shared_.task);
}

void EnvironmentSession::Answer(const SetRequest& request) {
  try {
    process_.Set(request.parameter, request.value);
  } catch (const UserError& error) {
    return messages_.TellError(error.what());
  }
  messages_.TellSet(request.parameter, process_.Get(request.parameter));
}

void EnvironmentSession::Answer(const ForeignRequest& request) {
  messages_.TellError(request.what);
}

}  // namespace runtime
