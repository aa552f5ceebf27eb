#include "runtime/core/task/told_sensors.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "base/variant/overloaded.h"
#include "plugins/host/scalar_bytes.h"
#include "plugins/robot/sensors.h"
#include "runtime/core/module/sensor_data.h"

namespace runtime {
namespace {

bool IsOwn(const taskc_sensor& sensor) { return robot::FindSensor(sensor.name) == nullptr; }

size_t SizeOf(const taskc_sensor& sensor) { return size_t{sensor.rows} * sensor.columns; }

bool IsSame(const taskc_sensor& a, const taskc_sensor& b) {
  return std::string_view(a.name) == b.name && std::string_view(a.type) == b.type &&
         std::string_view(a.unit) == b.unit && SizeOf(a) == SizeOf(b);
}

bool IsInRange(const taskc_sensor& sensor, double number) {
  return sensor.minimum <= number && number <= sensor.maximum;
}

const char* MeaningOf(const taskc_sensor& sensor) {
  return sensor.scalar == TASKC_BOOL ? "a sensor of the task, 0 or 1: what it is told"
                                     : "a sensor of the task: what it is told";
}

void CheckElement(const taskc_sensor& sensor, double number, const std::string& full_name) {
  if (sensor.scalar == TASKC_BOOL && number != 0 && number != 1)
    throw UserError(
        fmt::format("`{}` is made of conditions, 0 or 1, and {} is neither", full_name, number));
  if (sensor.scalar == TASKC_INT && number != std::floor(number))
    throw UserError(
        fmt::format("`{}` is made of whole numbers, and {} is not one", full_name, number));
}

}  // namespace

ToldSensors::ToldSensors(const taskc_plugin& plugin)
    : sensors_(plugin.sensors, plugin.sensor_count) {
  for (const taskc_sensor& sensor : sensors_) entries_.emplace_back(sensor);
}

std::vector<Parameter> ToldSensors::Parameters() {
  std::vector<Parameter> parameters;
  for (size_t i = 0; i < sensors_.size(); ++i) {
    const taskc_sensor& sensor = sensors_[i];
    if (!IsOwn(sensor)) continue;
    parameters.push_back({.name = sensor.name,
                          .doc = MeaningOf(sensor),
                          .target = &entries_[i].numbers,
                          .minimum = sensor.minimum,
                          .maximum = sensor.maximum,
                          .unit = sensor.unit});
  }
  return parameters;
}

std::optional<size_t> ToldSensors::Find(std::string_view name) const {
  for (size_t i = 0; i < sensors_.size(); ++i) {
    if (sensors_[i].name == name && IsOwn(sensors_[i])) return i;
  }
  return std::nullopt;
}

std::vector<double> ToldSensors::ElementsIn(size_t sensor, const ParameterValue& value,
                                            const std::string& full_name) const {
  const taskc_sensor& entry = sensors_[sensor];
  const size_t wanted = SizeOf(entry);
  std::vector<double> numbers = std::visit(
      variant::Overloaded{
          [](const std::vector<double>& list) { return list; },
          [&](const std::string&) -> std::vector<double> {
            throw UserError(fmt::format("`{}` is a `{}`, and {} is not one", full_name,
                                        SensorTypeText(entry.type, entry.unit), ToText(value)));
          },
          [](auto number) { return std::vector{static_cast<double>(number)}; },
      },
      value);
  if (numbers.size() != wanted) {
    throw UserError(fmt::format("`{}` is a `{}` with {} element{}, not {}", full_name,
                                SensorTypeText(entry.type, entry.unit), wanted,
                                wanted == 1 ? "" : "s", numbers.size()));
  }
  for (const double number : numbers) CheckElement(entry, number, full_name);
  return numbers;
}

void ToldSensors::Pass(size_t sensor) {
  Entry& entry = entries_[sensor];
  const taskc_int32 scalar = sensors_[sensor].scalar;
  for (size_t i = 0; i < entry.numbers.size(); ++i) {
    host::StoreScalar(entry.elements.data() + i * host::ScalarSize(scalar), scalar,
                      entry.numbers[i]);
  }
}

void ToldSensors::Forget(size_t sensor) { entries_[sensor].numbers.clear(); }

const std::vector<double>* ToldSensors::FindFor(const taskc_sensor& sensor) const {
  for (size_t i = 0; i < sensors_.size(); ++i) {
    if (!IsTold(i) || !IsSame(sensors_[i], sensor)) continue;
    const bool fits = std::ranges::all_of(entries_[i].numbers,
                                          [&](double number) { return IsInRange(sensor, number); });
    return fits ? &entries_[i].numbers : nullptr;
  }
  return nullptr;
}

void ToldSensors::TakeOver(const ToldSensors& old) {
  for (size_t i = 0; i < sensors_.size(); ++i) {
    const std::vector<double>* told = old.FindFor(sensors_[i]);
    if (told == nullptr) continue;
    entries_[i].numbers = *told;
    Pass(i);
  }
}

std::vector<std::pair<std::string, double>> ToldSensors::Saved() const {
  std::vector<std::pair<std::string, double>> saved;
  for (size_t i = 0; i < sensors_.size(); ++i) {
    for (size_t k = 0; k < entries_[i].numbers.size(); ++k)
      saved.emplace_back(fmt::format("{}[{}]", sensors_[i].name, k), entries_[i].numbers[k]);
  }
  return saved;
}

void ToldSensors::Restore(std::string_view name, double number) {
  const size_t bracket = name.find('[');
  if (bracket == std::string_view::npos) return;
  const std::optional<size_t> sensor = Find(name.substr(0, bracket));
  if (!sensor || !IsInRange(sensors_[*sensor], number)) return;
  const size_t size = SizeOf(sensors_[*sensor]);
  size_t element = size;
  std::from_chars(name.data() + bracket + 1, name.data() + name.size(), element);
  if (element >= size) return;
  entries_[*sensor].numbers.resize(size);
  entries_[*sensor].numbers[element] = number;
  Pass(*sensor);
}

}  // namespace runtime
