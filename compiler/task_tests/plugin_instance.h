// A plugin that runs on values of the evaluator's kind.
#pragma once

#include <taskc/plugin.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "compiler/check/value.h"
#include "plugins/host/task_frame.h"

namespace compiler {

class PluginInstance {
 public:
  // Refers to the plugin, which must stay loaded. Sensors are 0, memory has its initial values.
  explicit PluginInstance(const taskc_plugin& plugin);

  // Indices are those of the plugin's tables; a value has as many elements as the entry says.
  void SetSensor(size_t sensor, const Value& value);
  void SetParam(size_t param, double value) { host_.params()[param] = value; }
  void SetMemory(size_t memory, const Value& value);
  Value Memory(size_t memory) const;

  void SetSeed(uint64_t seed) { host_.SetSeed(seed); }
  int DrawPose() { return host_.DrawPose(); }
  void DrawStart(uint32_t attempt) { host_.DrawStart(attempt); }
  void SetDiscount(double discount) { host_.SetDiscount(discount); }
  // TASKC_SUCCESS ...
  void SetOutcome(int outcome) { host_.SetOutcome(outcome); }

  // An event that the task does not have does nothing.
  void Fire(int event, double time_step) { host_.Call(event, time_step); }
  void Measure() { host_.Measure(); }
  void Observe() { host_.Observe(); }

  const taskc_plugin& table() const { return host_.plugin(); }
  // What the last callback did.
  const taskc_frame& frame() const { return host_.frame(); }

 private:
  host::TaskFrame host_;
  std::vector<host::AlignedBytes> sensors_;
};

}  // namespace compiler
