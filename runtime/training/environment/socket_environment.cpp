#include "runtime/training/environment/socket_environment.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "runtime/core/module/sensor_data.h"
#include "runtime/core/module/sensor_type.h"

namespace runtime {
namespace {

// JSON numbers keep integers up to here in every language.
constexpr uint64_t kSeedMask = (uint64_t{1} << 53) - 1;

size_t SizeOf(const taskc_sensor& sensor) { return size_t{sensor.rows} * sensor.columns; }

size_t SizeOf(std::string_view type) { return ElementsOfType(type, {}); }

// What is beyond is no exact whole number anyway.
taskc_int64 ToInt(double number) {
  return static_cast<taskc_int64>(std::clamp(number, -0x1p62, 0x1p62));
}

std::string TextOf(const OfferedSensor& sensor) {
  return fmt::format("{}: {}", sensor.name, SensorTypeText(sensor.type, sensor.unit));
}

}  // namespace

SocketEnvironment::SocketEnvironment(std::string name, const Context& context)
    : SteppedEnvironment(std::move(name), context), task_(context.task) {
  AddParameter({.name = "path",
                .doc = "of the socket at which the environment, another program, listens",
                .target = &path_,
                .is_live = false});
  if (task_ == nullptr) return;
  const taskc_plugin& table = task_->table();
  for (const taskc_sensor& sensor : std::span(table.sensors, table.sensor_count)) {
    if (std::string_view(sensor.name) == "time") continue;  // counted here
    SocketSensor& added =
        sensors_.emplace_back(SocketSensor{sensor, std::vector<double>(SizeOf(sensor))});
    void* elements = added.elements.data();
    if (sensor.scalar == TASKC_BOOL) {
      AddSensor(sensor.name, sensor.type, sensor.unit, static_cast<bool*>(elements));
    } else if (sensor.scalar == TASKC_INT) {
      AddSensor(sensor.name, sensor.type, sensor.unit, static_cast<long long*>(elements));
    } else {
      AddSensor(sensor.name, sensor.type, sensor.unit, static_cast<double*>(elements));
    }
  }
}

SocketEnvironment::~SocketEnvironment() = default;

std::string SocketEnvironment::WhyOnlyOne() const {
  return fmt::format("`{}` is one program, which does one thing at a time", name());
}

void SocketEnvironment::Prepare() {
  if (link_ != nullptr) return;
  if (path_.empty()) {
    throw UserError(fmt::format(
        "the task `{}` names no robot; name one, for example `--robot humanoid`, or what supplies "
        "its sensors: an agent file with an environment (`--agent FILE.toml`), or a program that "
        "listens at a socket (`--environment-socket PATH`): docs/environments.md",
        task_ == nullptr ? "" : task_->table().name));
  }
  auto link = std::make_unique<EnvironmentLink>(path_);
  SetSteps(link->greeting().time_step, link->greeting().limits);
  link_ = std::move(link);
  FindSensors();
}

void SocketEnvironment::FindSensors() {
  const std::vector<OfferedSensor>& offered = link_->greeting().sensors;
  for (SocketSensor& wanted : sensors_) {
    const OfferedSensor sensor{wanted.sensor.name, wanted.sensor.type, wanted.sensor.unit};
    size_t first = 0;
    bool is_found = false;
    for (const OfferedSensor& each : offered) {
      is_found = TextOf(each) == TextOf(sensor);
      if (is_found) break;
      first += SizeOf(each.type);
    }
    if (!is_found) {
      std::vector<std::string> texts;
      for (const OfferedSensor& each : offered) texts.push_back(TextOf(each));
      throw UserError(fmt::format(
          "the task `{}` reads the sensor `{}`, which the environment at {} does not have: it has "
          "`{}`",
          task_->table().name, TextOf(sensor), path_, fmt::join(texts, "`, `")));
    }
    wanted.first = first;
  }
  size_t numbers = 0;
  for (const OfferedSensor& each : offered) {
    if (SizeOf(each.type) == 0) {
      throw UserError(
          fmt::format("the environment at {} has a sensor `{}`, of a type that there is "
                      "not",
                      path_, TextOf(each)));
    }
    numbers += SizeOf(each.type);
  }
  link_->ExpectNumbers(numbers);
}

void SocketEnvironment::Begin(uint64_t seed) { Take(link_->Reset(episode(), seed & kSeedMask)); }

void SocketEnvironment::Step(const Eigen::VectorXd& action) { Take(link_->Step(action)); }

void SocketEnvironment::Take(const EnvironmentReply& reply) {
  for (SocketSensor& each : sensors_) {
    const std::span<const double> numbers =
        link_->numbers().subspan(each.first, SizeOf(each.sensor));
    for (size_t i = 0; i < numbers.size(); ++i) {
      if (each.sensor.scalar == TASKC_BOOL) {
        reinterpret_cast<bool*>(each.elements.data())[i] = numbers[i] != 0;
      } else if (each.sensor.scalar == TASKC_INT) {
        reinterpret_cast<taskc_int64*>(each.elements.data())[i] = ToInt(numbers[i]);
      } else {
        each.elements[i] = numbers[i];
      }
    }
  }
  if (!reply.end) return;
  reason_ = reply.reason;
  EndEpisode(*reply.end, reason_.c_str());
}

}  // namespace runtime
