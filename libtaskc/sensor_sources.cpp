#include "libtaskc/sensor_sources.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "libtaskc/failure.h"

namespace libtaskc {

SensorSources::SensorSources(host::TaskFrame& frame) : frame_(frame) {
  for (size_t i = 0; i < frame.plugin().sensor_count; ++i) sources_.emplace_back(SensorAt(i));
  for (size_t i = 0; i < sources_.size(); ++i) frame_.sensor(i) = sources_[i].elements.data();
}

std::byte* SensorSources::ElementsOf(const Target& target) {
  const taskc_sensor& sensor = SensorAt(target.sensor);
  return sources_[target.sensor].elements.data() +
         size_t{target.first_row} * sensor.columns * host::ScalarSize(sensor.scalar);
}

void SensorSources::Bind(const char* sensor, const char* unit, const taskc_view& view,
                         ptrdiff_t time_stride) {
  const Target target = FindTarget(frame_.plugin(), sensor, unit);
  Filling filling{.is_bound = true, .time_stride = time_stride};
  filling.runs = RunsOf(frame_.plugin(), target, view, time_stride, ElementsOf(target));
  // Of an entry there is always a copy: the frame reads whole sensors only where they are.
  if (!target.is_entry && IsInPlace(SensorAt(target.sensor), view, filling.runs)) {
    filling.in_place = filling.runs.front().from;
    filling.runs.clear();
  }
  Set(target, std::move(filling));
}

void SensorSources::BindFunction(const char* sensor, const char* unit,
                                 taskc_sensor_function function, void* user) {
  const Target target = FindTarget(frame_.plugin(), sensor, unit);
  if (function == nullptr) throw Failure(TASKC_ERROR_NULL, "the function is null");
  Set(target, {.is_bound = true, .call = {function, user, ElementsOf(target)}});
}

void SensorSources::Set(const Target& target, Filling filling) {
  Source& source = sources_[target.sensor];
  if (!target.is_entry) {
    source.whole = std::move(filling);
    source.rows.clear();
  } else {
    source.rows.resize(SensorAt(target.sensor).rows);
    source.rows[target.first_row] = std::move(filling);
    source.whole = {};
  }
  const void* const in_place = source.whole.in_place;
  frame_.sensor(target.sensor) = in_place != nullptr ? in_place : source.elements.data();
  for (taskc_uint32 reader = 0; reader < TASKC_READER_COUNT; ++reader) {
    if ((SensorAt(target.sensor).read_by >> reader & 1) != 0)
      readings_[reader] = ReadingsFor(1u << reader);
  }
}

void SensorSources::AddReadings(size_t sensor, SensorReadings& readings) const {
  const auto add = [&](const Filling& filling) {
    readings.runs.insert(readings.runs.end(), filling.runs.begin(), filling.runs.end());
    if (filling.call.function != nullptr) readings.calls.push_back(filling.call);
  };
  add(sources_[sensor].whole);
  for (const Filling& filling : sources_[sensor].rows) add(filling);
}

SensorReadings SensorSources::ReadingsFor(taskc_uint32 readers, taskc_uint32 others) const {
  SensorReadings readings;
  for (size_t i = 0; i < sources_.size(); ++i) {
    const taskc_uint32 read_by = SensorAt(i).read_by;
    if ((read_by & readers) != 0 && (read_by & others) == 0) AddReadings(i, readings);
  }
  return readings;
}

std::vector<ptrdiff_t> SensorSources::TimeStrides() const {
  std::vector<ptrdiff_t> strides;
  for (const Source& source : sources_)
    strides.push_back(source.whole.in_place == nullptr ? 0 : source.whole.time_stride);
  return strides;
}

std::vector<std::string> SensorSources::MissingOf(size_t sensor) const {
  const Source& source = sources_[sensor];
  const char* const name = SensorAt(sensor).name;
  if (source.whole.is_bound) return {};
  if (source.rows.empty()) return {fmt::format("`{}`", name)};
  std::vector<std::string> missing;
  for (size_t row = 0; row < source.rows.size(); ++row)
    if (!source.rows[row].is_bound) missing.push_back(fmt::format("`{}[{}]`", name, row));
  return missing;
}

void SensorSources::RequireFor(taskc_uint32 readers) const {
  std::vector<std::string> missing;
  for (size_t i = 0; i < sources_.size(); ++i) {
    if ((SensorAt(i).read_by & readers) == 0) continue;
    for (std::string& name : MissingOf(i)) missing.push_back(std::move(name));
  }
  if (missing.empty()) return;
  throw Failure(TASKC_ERROR_NOT_BOUND,
                fmt::format("the task `{}` reads {}, which {} not bound", frame_.plugin().name,
                            fmt::join(missing, ", "), missing.size() == 1 ? "is" : "are"));
}

}  // namespace libtaskc
