#include "compiler/testing/plugin_instance.h"

#include <cstring>
#include <span>

namespace compiler {
namespace {

size_t SizeOf(taskc_int32 scalar) { return scalar == TASKC_BOOL ? 1 : 8; }

void Store(std::byte* place, taskc_int32 scalar, const Value& value) {
  std::visit(
      [&](const auto& elements) {
        for (size_t i = 0; i < elements.size(); ++i) {
          if (scalar == TASKC_BOOL) {
            place[i] = std::byte{elements[i] != 0};
          } else {
            std::memcpy(place + i * sizeof elements[i], &elements[i], sizeof elements[i]);
          }
        }
      },
      value);
}

template <typename Number>
std::vector<Number> LoadNumbers(const std::byte* place, size_t count) {
  std::vector<Number> numbers(count);
  std::memcpy(numbers.data(), place, count * sizeof(Number));
  return numbers;
}

Value Load(const std::byte* place, taskc_int32 scalar, size_t count) {
  if (scalar == TASKC_REAL) return LoadNumbers<double>(place, count);
  if (scalar == TASKC_INT) return LoadNumbers<int64_t>(place, count);
  Integers bools;
  for (size_t i = 0; i < count; ++i) bools.push_back(std::to_integer<int64_t>(place[i]));
  return bools;
}

}  // namespace

PluginInstance::PluginInstance(const taskc_plugin& plugin) : plugin_(plugin) {
  constexpr size_t kBlock = sizeof(Block);
  for (const taskc_sensor& sensor : std::span(plugin.sensors, plugin.sensor_count)) {
    const size_t bytes = sensor.rows * sensor.columns * SizeOf(sensor.scalar);
    sensors_.emplace_back((bytes + kBlock - 1) / kBlock);
    sensor_pointers_.push_back(sensors_.back().data());
  }
  for (const taskc_param& param : std::span(plugin.params, plugin.param_count)) {
    params_.push_back(param.initial);
  }
  memory_.resize((plugin.memory_size + kBlock - 1) / kBlock);
  // A plugin may not rely on zeroes.
  for (Block& block : memory_) std::memset(block.bytes, 0xEE, kBlock);
  terms_.resize(plugin.term_count);
  metrics_.resize(plugin.metric_count);
  logs_.resize(plugin.log_count);
  frame_.sensors = sensor_pointers_.data();
  frame_.params = params_.data();
  frame_.memory = memory_.data();
  frame_.terms = terms_.data();
  frame_.metrics = metrics_.data();
  frame_.logs = logs_.data();
  Prepare(0);
  plugin_.initialize(&frame_);
}

void PluginInstance::SetSensor(size_t sensor, const Value& value) {
  Store(sensors_[sensor].front().bytes, plugin_.sensors[sensor].scalar, value);
}

std::byte* PluginInstance::PlaceOf(size_t memory) const {
  return static_cast<std::byte*>(frame_.memory) + plugin_.memory[memory].offset;
}

void PluginInstance::SetMemory(size_t memory, const Value& value) {
  Store(PlaceOf(memory), plugin_.memory[memory].scalar, value);
}

Value PluginInstance::Memory(size_t memory) const {
  const taskc_memory& entry = plugin_.memory[memory];
  return Load(PlaceOf(memory), entry.scalar, entry.rows * entry.columns);
}

void PluginInstance::Prepare(double time_step) {
  frame_.time_step = time_step;
  frame_.reward = 0;
  frame_.end = -1;
  frame_.fault = -1;
  frame_.violation = -1;
}

void PluginInstance::Fire(size_t event, double time_step) {
  Prepare(time_step);
  if (plugin_.events[event] != nullptr) plugin_.events[event](&frame_);
}

void PluginInstance::Measure() {
  if (plugin_.measure != nullptr) plugin_.measure(&frame_);
}

}  // namespace compiler
