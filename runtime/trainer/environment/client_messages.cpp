#include "runtime/trainer/environment/client_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "runtime/core/module/end_kind_name.h"
#include "runtime/training/environment/socket_messages.h"
#include "runtime/training/learning/terminal_end.h"
#include "runtime/training/run/value_json.h"

namespace runtime {
namespace {

using Json = nlohmann::ordered_json;

constexpr uint64_t kNoSeed = ~uint64_t{0};

Json LimitJson(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json JsonOf(const ObservationLayout& layout) {
  Json list = Json::array();
  for (const ObservedValue& value : layout.values) {
    list.push_back({{"name", value.name},
                    {"type", value.type},
                    {"unit", value.unit},
                    {"size", value.size},
                    {"low", LimitJson(value.minimum)},
                    {"high", LimitJson(value.maximum)}});
  }
  return list;
}

Json JsonOf(const std::vector<OfferedParam>& params) {
  Json list = Json::array();
  for (const OfferedParam& param : params) {
    list.push_back({{"name", param.name},
                    {"unit", param.unit},
                    {"value", ToJson(param.value)},
                    {"low", LimitJson(param.minimum)},
                    {"high", LimitJson(param.maximum)}});
  }
  return list;
}

// Throws Json::exception and UserError.
SetRequest SetFrom(const Json& request) {
  const auto parameter = request["set"].get<std::string>();
  return {parameter, ValueFromJson(request.at("value"), parameter)};
}

template <class Record>
Json ByName(const std::vector<Record>& records, const std::vector<double>& values) {
  Json json = Json::object();
  for (size_t i = 0; i < values.size(); ++i) json[records[i].name] = values[i];
  return json;
}

void AddNumbers(const Eigen::VectorXd& numbers, Json& reply) {
  reply["observation"] = std::vector<double>(numbers.begin(), numbers.end());
}

}  // namespace

void ClientMessages::Send(const std::string& bytes) {
  if (!socket_.Write(bytes)) throw ClientIsGone();
}

void ClientMessages::Greet(const std::string& about, int action_size,
                           const ObservationLayout& observation, std::vector<OfferedParam> params) {
  action_.setZero(action_size);
  params_ = std::move(params);
  Json greeting = Json::parse(about);
  const auto size = static_cast<size_t>(action_size);
  greeting["action"] = {{"low", std::vector(size, -1.0)}, {"high", std::vector(size, 1.0)}};
  greeting["observation"] = JsonOf(observation);
  greeting["params"] = JsonOf(params_);
  greeting["formats"] = {"json", "binary"};
  Send(greeting.dump() + "\n");
}

ClientRequest ClientMessages::Wait() { return is_binary_ ? WaitForBinary() : WaitForText(); }

ClientRequest ClientMessages::WaitForText() {
  const std::optional<std::string> line = socket_.ReadLine();
  if (!line) throw ClientIsGone();
  try {
    const Json request = Json::parse(*line);
    if (request.contains("format")) {
      is_binary_ = request["format"] == "binary";
      if (is_binary_ || request["format"] == "json") return Wait();
    }
    if (const auto reset = request.find("reset"); reset != request.end()) {
      if (!reset->is_object() || !reset->contains("seed")) return ResetRequest{};
      return ResetRequest{reset->at("seed").get<uint64_t>()};
    }
    if (request.contains("set")) return SetFrom(request);
    const auto step = request.at("step").get<std::vector<double>>();
    if (static_cast<Eigen::Index>(step.size()) != action_.size()) {
      return ForeignRequest{
          fmt::format("an action has {} numbers, not {}", action_.size(), step.size())};
    }
    std::ranges::copy(step, action_.begin());
    return StepRequest{};
  } catch (const Json::exception&) {
    return ForeignRequest{
        "a request is {\"reset\": {\"seed\": 1}}, {\"reset\": {}}, {\"step\": [0.5, ...]} or "
        "{\"set\": \"task.weight\", \"value\": 2}"};
  } catch (const UserError& error) {
    return ForeignRequest{error.what()};
  }
}

template <class Value>
Value ClientMessages::ReadBinary() {
  Value value{};
  if (!socket_.Read(std::as_writable_bytes(std::span(&value, 1)))) throw ClientIsGone();
  return value;
}

ClientRequest ClientMessages::WaitForBinary() {
  switch (ReadBinary<uint8_t>()) {
    case kBinaryReset: {
      const auto seed = ReadBinary<uint64_t>();
      return seed == kNoSeed ? ResetRequest{} : ResetRequest{seed};
    }
    case kBinaryStep:
      for (double& element : action_) element = ReadBinary<double>();
      return StepRequest{};
    case kBinarySet:
      return ReadBinarySet();
    default:
      throw ClientIsGone();
  }
}

SetRequest ClientMessages::ReadBinarySet() {
  const auto index = ReadBinary<uint32_t>();
  const auto value = ReadBinary<double>();
  if (index >= params_.size()) throw ClientIsGone();
  const OfferedParam& param = params_[index];
  const bool is_flag = std::holds_alternative<bool>(param.value) && (value == 0 || value == 1);
  return {param.name, is_flag ? ParameterValue(value == 1) : ParameterValue(value)};
}

void ClientMessages::SendBinary(uint8_t end, double reward, const Eigen::VectorXd& observation) {
  const size_t numbers = static_cast<size_t>(observation.size()) * sizeof(double);
  bytes_.resize(1 + sizeof reward + numbers);
  bytes_[0] = static_cast<char>(end);
  std::memcpy(&bytes_[1], &reward, sizeof reward);
  std::memcpy(&bytes_[1 + sizeof reward], observation.data(), numbers);
  Send(bytes_);
}

void ClientMessages::TellStart(const Eigen::VectorXd& observation) {
  if (is_binary_) return SendBinary(kBinaryGoesOn, 0, observation);
  Json reply;
  AddNumbers(observation, reply);
  Send(reply.dump() + "\n");
}

void ClientMessages::TellStep(const Eigen::VectorXd& observation, double reward, double time) {
  if (is_binary_) return SendBinary(kBinaryGoesOn, reward, observation);
  Json reply;
  AddNumbers(observation, reply);
  reply["reward"] = reward;
  reply["terminated"] = false;
  reply["truncated"] = false;
  reply["time"] = time;
  Send(reply.dump() + "\n");
}

void ClientMessages::TellEnd(const Eigen::VectorXd& observation, double reward,
                             const EpisodeRecord& episode, const TaskRecord& task) {
  const Evaluation& evaluation = episode.active;
  const EndKind kind = EndKindCalled(evaluation.end_kind).value();
  if (is_binary_) return SendBinary(BinaryEnd(kind), reward, observation);
  const bool is_terminal = IsTerminal(kind);
  Json reply;
  AddNumbers(observation, reply);
  reply["reward"] = reward;
  reply["terminated"] = is_terminal;
  reply["truncated"] = !is_terminal;
  reply["time"] = episode.simulated_seconds;
  reply["end"] = {{"kind", evaluation.end_kind}, {"reason", evaluation.end_reason}};
  reply["return"] = evaluation.episode_return;
  reply["terms"] = ByName(task.terms, evaluation.terms);
  reply["metrics"] = ByName(task.metrics, evaluation.metrics);
  Send(reply.dump() + "\n");
}

void ClientMessages::TellSet(const std::string& parameter, const ParameterValue& value) {
  if (is_binary_) return;
  Json reply;
  reply["set"] = parameter;
  reply["value"] = ToJson(value);
  Send(reply.dump() + "\n");
}

void ClientMessages::TellError(const std::string& what) {
  if (is_binary_) throw ClientIsGone();
  Json reply;
  reply["error"] = what;
  Send(reply.dump() + "\n");
}

}  // namespace runtime
