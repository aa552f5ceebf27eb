#include "compiler/task_tests/plugin_instance.h"

#include <algorithm>
#include <cstring>

namespace compiler {
namespace {

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

PluginInstance::PluginInstance(const taskc_plugin& plugin) : host_(plugin) {
  for (uint32_t i = 0; i < plugin.sensor_count; ++i) {
    sensors_.emplace_back(host::SizeInBytes(plugin.sensors[i]));
    host_.sensor(i) = sensors_.back().data();
  }
  // A plugin may not rely on zeroes.
  std::ranges::fill(host_.memory(), std::byte{0xEE});
  host_.Initialize();
}

void PluginInstance::SetSensor(size_t sensor, const Value& value) {
  Store(sensors_[sensor].data(), host_.plugin().sensors[sensor].scalar, value);
}

void PluginInstance::SetMemory(size_t memory, const Value& value) {
  const taskc_memory& entry = host_.plugin().memory[memory];
  Store(host_.Bytes(entry).data(), entry.scalar, value);
}

Value PluginInstance::Memory(size_t memory) const {
  const taskc_memory& entry = host_.plugin().memory[memory];
  return Load(host_.Bytes(entry).data(), entry.scalar, entry.rows * entry.columns);
}

}  // namespace compiler
