#include "runtime/training/environment/environment_link.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "runtime/base/user_error.h"
#include "runtime/core/module/end_kind_name.h"
#include "runtime/training/environment/socket_messages.h"

namespace runtime {
namespace {

using nlohmann::json;

static_assert(std::endian::native == std::endian::little, "binary messages are little-endian");

constexpr std::chrono::milliseconds kPatience{5000};

std::string Shortened(const std::string& text) {
  constexpr size_t kMost = 100;
  return text.size() <= kMost ? text : text.substr(0, kMost) + " ...";
}

Eigen::VectorXd VectorFrom(const json& list) {
  const auto numbers = list.get<std::vector<double>>();
  return Eigen::VectorXd::Map(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

template <class Number>
void AppendBytes(std::string& bytes, Number number) {
  const auto raw = std::bit_cast<std::array<char, sizeof number>>(number);
  bytes.append(raw.data(), raw.size());
}

EnvironmentReply EndFrom(const json& reply) {
  EnvironmentReply end;
  const auto found = reply.find("end");
  if (found == reply.end() || found->is_null()) return end;
  const auto kind = found->at("kind").get<std::string>();
  end.end = EndKindCalled(kind);
  if (!end.end) throw json::other_error::create(0, "`kind` is no end", nullptr);
  end.reason = found->value("reason", kind);
  return end;
}

}  // namespace

EnvironmentGreeting ParseGreeting(const std::string& line) {
  EnvironmentGreeting greeting;
  try {
    const json text = json::parse(line);
    const int version = text.at("taskc_environment");
    if (version != kSocketVersion) {
      throw UserError(fmt::format("it speaks version {}, and this program version {}", version,
                                  kSocketVersion));
    }
    text.at("time_step").get_to(greeting.time_step);
    greeting.limits = {VectorFrom(text.at("action").at("low")),
                       VectorFrom(text.at("action").at("high"))};
    for (const json& sensor : text.at("sensors")) {
      greeting.sensors.push_back(
          {sensor.at("name"), sensor.at("type"), sensor.value("unit", std::string())});
    }
    const auto formats = text.value("formats", std::vector<std::string>());
    greeting.speaks_binary = std::ranges::find(formats, "binary") != formats.end();
  } catch (const json::exception& error) {
    throw UserError(
        fmt::format("it greets with `{}`, which is no greeting of an environment: {}; "
                    "docs/environments.md says what one is",
                    Shortened(line), error.what()));
  }
  return greeting;
}

EnvironmentLink::EnvironmentLink(const std::filesystem::path& path)
    : path_(path), socket_(path, kPatience) {
  const std::optional<std::string> line = socket_.ReadLine();
  if (!line) ThrowGone();
  try {
    greeting_ = ParseGreeting(*line);
  } catch (const UserError& error) {
    throw UserError(fmt::format("the environment at {}: {}", path_.string(), error.what()));
  }
  if (greeting_.speaks_binary && !socket_.Write("{\"format\":\"binary\"}\n")) ThrowGone();
}

EnvironmentReply EnvironmentLink::Reset(int64_t episode, uint64_t seed) {
  episode_ = episode;
  steps_ = -1;  // the reply to a reset follows no step
  if (!greeting_.speaks_binary) {
    json request;
    request["reset"]["episode"] = episode;
    request["reset"]["seed"] = seed;
    return Exchange(request.dump() + "\n");
  }
  request_.assign(1, kBinaryReset);
  AppendBytes(request_, seed);
  return Exchange(request_);
}

EnvironmentReply EnvironmentLink::Step(const Eigen::VectorXd& action) {
  if (!greeting_.speaks_binary) {
    json request;
    request["step"] = std::vector<double>(action.begin(), action.end());
    return Exchange(request.dump() + "\n");
  }
  request_.assign(1, kBinaryStep);
  for (const double element : action) AppendBytes(request_, element);
  return Exchange(request_);
}

EnvironmentReply EnvironmentLink::Exchange(const std::string& request) {
  if (!socket_.Write(request)) ThrowGone();
  const EnvironmentReply reply = greeting_.speaks_binary ? ReadBinary() : ReadText();
  ++steps_;
  return reply;
}

EnvironmentReply EnvironmentLink::ReadText() {
  const std::optional<std::string> line = socket_.ReadLine();
  if (!line) ThrowGone();
  try {
    const json reply = json::parse(*line);
    const auto numbers = reply.at("sensors").get<std::vector<double>>();
    if (numbers.size() != numbers_.size()) {
      ThrowForeign(*line, fmt::format("`sensors` has {} numbers, and its sensors have {}",
                                      numbers.size(), numbers_.size()));
    }
    std::ranges::copy(numbers, numbers_.begin());
    return EndFrom(reply);
  } catch (const json::exception& error) {
    ThrowForeign(*line, error.what());
  }
}

EnvironmentReply EnvironmentLink::ReadBinary() {
  uint8_t end = 0;
  if (!socket_.Read(std::as_writable_bytes(std::span(&end, 1))) ||
      !socket_.Read(std::as_writable_bytes(std::span(numbers_)))) {
    ThrowGone();
  }
  if (end > kEndKinds.size()) ThrowForeign(fmt::format("the byte {}", end), "it is no kind of end");
  const auto bad = std::ranges::find_if(numbers_, [](double each) { return !std::isfinite(each); });
  if (bad != numbers_.end()) ThrowForeign(fmt::format("{}", *bad), "it is no number");
  if (end == kBinaryGoesOn) return {};
  const EndKind kind = kEndKinds[end - 1u];
  return {kind, std::string(EndKindName(kind))};
}

void EnvironmentLink::ThrowGone() const {
  const std::string when = episode_ == 0 ? "before the first episode"
                                         : fmt::format("in episode {} after {} time steps",
                                                       episode_, std::max<int64_t>(steps_, 0));
  throw UserError(
      fmt::format("the environment at {} has closed the connection {}", path_.string(), when));
}

void EnvironmentLink::ThrowForeign(const std::string& reply, const std::string& what) const {
  throw UserError(fmt::format(
      "the environment at {} replies with `{}`: {}; docs/environments.md says what a reply is",
      path_.string(), Shortened(reply), what));
}

}  // namespace runtime
