// How sensors travel from an environment to the tasks and states that read them.
#pragma once

#include <string>
#include <string_view>

#include "runtime/core/module/port.h"

namespace runtime {

// Where a sensor's elements lie, contiguously (plugins/abi/taskc/plugin.h says how). Owned
// by the environment; the elements stay where they are until the environment is destroyed.
struct SensorData {
  const void* data = nullptr;

  const double* reals() const { return static_cast<const double*>(data); }
  const bool* flags() const { return static_cast<const bool*>(data); }
};

template <>
struct TypeText<SensorData> {
  static constexpr const char* value = "sensor";
};

// Give these ports SensorTypeText() as their type's text, so that only sensors of one type and unit
// can be connected.
using SensorOut = Out<SensorData>;
using SensorIn = In<SensorData>;

// "vec3 [m/s]", or "quat" where the unit is "".
inline std::string SensorTypeText(std::string_view type, std::string_view unit) {
  std::string text(type);
  if (!unit.empty()) text.append(" [").append(unit).append("]");
  return text;
}

}  // namespace runtime
