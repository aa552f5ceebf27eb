// One host of a plugin: the memory that it works on.
#pragma once

#include <taskc/plugin.h>

#include <cstddef>
#include <vector>

#include "compiler/evaluate/value.h"

namespace compiler {

class PluginInstance {
 public:
  // Refers to the plugin, which must stay loaded. Sensors are 0, memory has its initial values.
  explicit PluginInstance(const taskc_plugin& plugin);

  // Indices are those of the plugin's tables; a value has as many elements as the entry says.
  void SetSensor(size_t sensor, const Value& value);
  void SetParam(size_t param, double value) { params_[param] = value; }
  void SetMemory(size_t memory, const Value& value);
  Value Memory(size_t memory) const;

  // An event that the task does not have does nothing.
  void Fire(size_t event, double time_step);
  void Measure();

  // What the last callback did.
  const taskc_frame& frame() const { return frame_; }

 private:
  // Aligned as the ABI demands.
  struct alignas(16) Block {
    std::byte bytes[16];
  };
  // What the ABI asks of a host before each call.
  void Prepare(double time_step);
  std::byte* PlaceOf(size_t memory) const;

  const taskc_plugin& plugin_;
  std::vector<std::vector<Block>> sensors_;
  std::vector<const void*> sensor_pointers_;
  std::vector<double> params_;
  std::vector<Block> memory_;
  std::vector<double> terms_;
  std::vector<double> metrics_;
  std::vector<taskc_log_state> logs_;
  taskc_frame frame_{};
};

}  // namespace compiler
