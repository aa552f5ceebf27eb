// What a task is told of the sensors that it declares itself, in place of a module that offers
// them.
#pragma once

#include <taskc/plugin.h>

#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plugins/host/task_frame.h"
#include "runtime/core/module/module.h"

namespace runtime {

class ToldSensors {
 public:
  // `plugin` outlives this. Nothing is told yet.
  explicit ToldSensors(const taskc_plugin& plugin);

  // One for each of the task's own sensors, of its name: a list of its elements in SI units, row by
  // row; an empty list: it is not told. They refer to this object.
  std::vector<Parameter> Parameters();

  // Its index in the plugin's table, if `name` is that of one of the task's own sensors.
  std::optional<size_t> Find(std::string_view name) const;
  // The list that says the same as `value`. Throws UserError, which calls the sensor `full_name`,
  // for another number of elements, a bool that is not 0 or 1, and an int that is not whole.
  std::vector<double> ElementsIn(size_t sensor, const ParameterValue& value,
                                 const std::string& full_name) const;
  // After its parameter was set.
  void Pass(size_t sensor);
  void Forget(size_t sensor);

  bool IsTold(size_t sensor) const { return !entries_[sensor].numbers.empty(); }
  // What the plugin reads. It stays where it is.
  const void* Data(size_t sensor) const { return entries_[sensor].elements.data(); }

  // Whether a task that reads `sensor` would take over what is told here: name, type and unit are
  // the same, and the range allows it.
  bool IsToldFor(const taskc_sensor& sensor) const { return FindFor(sensor) != nullptr; }
  void TakeOver(const ToldSensors& old);

  // What is told, as names with a number each: "ball.position[2]".
  std::vector<std::pair<std::string, double>> Saved() const;
  // One of these. Those of other sensors are left out.
  void Restore(std::string_view name, double number);

 private:
  struct Entry {
    explicit Entry(const taskc_sensor& sensor) : elements(host::SizeInBytes(sensor)) {}
    std::vector<double> numbers;
    host::AlignedBytes elements;
  };

  const std::vector<double>* FindFor(const taskc_sensor& sensor) const;

  std::span<const taskc_sensor> sensors_;
  std::vector<Entry> entries_;  // one for each sensor, of which those of robots are never told
};

}  // namespace runtime
