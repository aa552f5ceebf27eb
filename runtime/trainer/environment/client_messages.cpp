#include "runtime/trainer/environment/client_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

namespace runtime {
namespace {

using Json = nlohmann::ordered_json;

constexpr uint8_t kReset = 1;
constexpr uint8_t kStep = 2;
constexpr uint64_t kNoSeed = ~uint64_t{0};
// As the binary replies number them.
constexpr std::array kEndKinds = {EndKind::kSuccess, EndKind::kFailure, EndKind::kTruncated,
                                  EndKind::kDiverged};

Json ToJson(const ObservationLayout& layout) {
  const auto limit = [](double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
  };
  Json list = Json::array();
  for (const ObservedValue& value : layout.values) {
    list.push_back({{"name", value.name},
                    {"type", value.type},
                    {"unit", value.unit},
                    {"size", value.size},
                    {"low", limit(value.minimum)},
                    {"high", limit(value.maximum)}});
  }
  return list;
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
                           const ObservationLayout& observation) {
  action_.setZero(action_size);
  Json greeting = Json::parse(about);
  const auto size = static_cast<size_t>(action_size);
  greeting["action"] = {{"low", std::vector(size, -1.0)}, {"high", std::vector(size, 1.0)}};
  greeting["observation"] = ToJson(observation);
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
    const auto step = request.at("step").get<std::vector<double>>();
    if (static_cast<Eigen::Index>(step.size()) != action_.size()) {
      return ForeignRequest{
          fmt::format("an action has {} numbers, not {}", action_.size(), step.size())};
    }
    std::ranges::copy(step, action_.begin());
    return StepRequest{};
  } catch (const Json::exception&) {
    return ForeignRequest{
        "a request is {\"reset\": {\"seed\": 1}}, {\"reset\": {}} or {\"step\": [0.5, ...]}"};
  }
}

ClientRequest ClientMessages::WaitForBinary() {
  const auto read = [this](auto span) {
    if (!socket_.Read(std::as_writable_bytes(span))) throw ClientIsGone();
  };
  uint8_t kind = 0;
  read(std::span(&kind, 1));
  if (kind == kReset) {
    uint64_t seed = 0;
    read(std::span(&seed, 1));
    return seed == kNoSeed ? ResetRequest{} : ResetRequest{seed};
  }
  if (kind != kStep) throw ClientIsGone();
  read(std::span(action_.data(), static_cast<size_t>(action_.size())));
  return StepRequest{};
}

void ClientMessages::SendBinary(int kind, double reward, const Eigen::VectorXd& observation) {
  const size_t numbers = static_cast<size_t>(observation.size()) * sizeof(double);
  bytes_.resize(1 + sizeof reward + numbers);
  bytes_[0] = static_cast<char>(kind);
  std::memcpy(&bytes_[1], &reward, sizeof reward);
  std::memcpy(&bytes_[1 + sizeof reward], observation.data(), numbers);
  Send(bytes_);
}

void ClientMessages::TellStart(const Eigen::VectorXd& observation) {
  if (is_binary_) return SendBinary(0, 0, observation);
  Json reply;
  AddNumbers(observation, reply);
  Send(reply.dump() + "\n");
}

void ClientMessages::TellStep(const Eigen::VectorXd& observation, double reward, double time) {
  if (is_binary_) return SendBinary(0, reward, observation);
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
  const auto* kind = std::ranges::find(kEndKinds, evaluation.end_kind, EndKindName);
  const auto number = static_cast<int>(kind - kEndKinds.begin());
  if (is_binary_) return SendBinary(1 + number, reward, observation);
  const bool is_terminal = number < 2;
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

void ClientMessages::TellError(const std::string& what) {
  if (is_binary_) throw ClientIsGone();
  Json reply;
  reply["error"] = what;
  Send(reply.dump() + "\n");
}

}  // namespace runtime
