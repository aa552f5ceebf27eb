#include "libtaskc/sensor_run.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>

#include "libtaskc/failure.h"
#include "libtaskc/lookup.h"
#include "plugins/host/task_frame.h"

namespace libtaskc {
namespace {

std::span<const taskc_sensor> SensorsOf(const taskc_plugin& task) {
  return {task.sensors, task.sensor_count};
}

// ---- Names --------------------------------------------------------------------------------------

std::string_view IndexTypeOf(const taskc_sensor& sensor) {
  const std::string_view type = sensor.type;
  const size_t bracket = type.find('[');
  return bracket == type.npos ? "" : type.substr(bracket + 1, type.size() - bracket - 2);
}

bool IsQuaternion(const taskc_sensor& sensor) {
  return std::string_view(sensor.type).starts_with("quat");
}

std::optional<taskc_uint32> NumberIn(std::string_view text) {
  taskc_uint32 number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

taskc_uint32 RowOf(const taskc_plugin& task, const taskc_sensor& sensor, const std::string& entry) {
  const std::string_view index = IndexTypeOf(sensor);
  if (index.empty()) {
    throw Failure(
        TASKC_ERROR_UNKNOWN_NAME,
        fmt::format("the sensor `{}` has no entries: it is a `{}`", sensor.name, sensor.type));
  }
  if (const auto number = NumberIn(entry)) {
    if (*number < sensor.rows) return *number;
    throw Failure(TASKC_ERROR_UNKNOWN_NAME,
                  fmt::format("the sensor `{}` has the entries 0 .. {}, not {}", sensor.name,
                              sensor.rows - 1, *number));
  }
  std::span<const taskc_part> parts;
  if (index == "link") parts = {task.links, task.link_count};
  if (index == "joint") parts = {task.joints, task.joint_count};
  if (index == "site") parts = {task.sites, task.site_count};
  return static_cast<taskc_uint32>(IndexOf(task, parts, entry.c_str(), index));
}

// ---- Formats ------------------------------------------------------------------------------------

template <class From, class To>
void CopyRun(const std::byte* from, ptrdiff_t stride, size_t count, std::byte* to) {
  for (size_t i = 0; i < count; ++i) {
    From number;
    std::memcpy(&number, from + static_cast<ptrdiff_t>(i) * stride, sizeof number);
    To element;
    if constexpr (std::is_same_v<To, unsigned char>) {
      element = number != 0;
    } else {
      element = static_cast<To>(number);
    }
    std::memcpy(to + i * sizeof element, &element, sizeof element);
  }
}

template <class From>
Run::Copy CopyFrom(taskc_int32 scalar) {
  if (scalar == TASKC_BOOL) return CopyRun<From, unsigned char>;
  if (scalar == TASKC_INT) {
    if constexpr (std::is_floating_point_v<From>) return nullptr;
    return CopyRun<From, taskc_int64>;
  }
  return CopyRun<From, double>;
}

struct Format {
  size_t size = 0;           // of one number; 0: there is no such format
  Run::Copy copy = nullptr;  // null: a number cannot become such an element
};

Format FormatOf(taskc_int32 format, taskc_int32 scalar) {
  switch (format) {
    case TASKC_FLOAT64:
      return {sizeof(double), CopyFrom<double>(scalar)};
    case TASKC_FLOAT32:
      return {sizeof(float), CopyFrom<float>(scalar)};
    case TASKC_INT64:
      return {sizeof(int64_t), CopyFrom<int64_t>(scalar)};
    case TASKC_INT32:
      return {sizeof(int32_t), CopyFrom<int32_t>(scalar)};
    case TASKC_UINT8:
    case TASKC_BOOL8:
      return {1, CopyFrom<unsigned char>(scalar)};
    default:
      return {};
  }
}

taskc_int32 OwnFormat(taskc_int32 scalar) {
  if (scalar == TASKC_REAL) return TASKC_FLOAT64;
  return scalar == TASKC_INT ? TASKC_INT64 : TASKC_BOOL8;
}

Format CheckedFormat(const taskc_sensor& sensor, const taskc_view& view) {
  const Format format = FormatOf(view.format, sensor.scalar);
  if (format.copy != nullptr) return format;
  throw Failure(TASKC_ERROR_WRONG_TYPE,
                format.size == 0
                    ? fmt::format("there is no format {}", view.format)
                    : fmt::format("the sensor `{}` is of ints, and takes no floats", sensor.name));
}

void CheckShape(const taskc_sensor& sensor, const Target& target, const taskc_view& view) {
  const taskc_uint32 rows = view.rows == 0 ? target.rows : view.rows;
  const taskc_uint32 columns = view.columns == 0 ? target.columns : view.columns;
  if (rows != target.rows || columns != target.columns) {
    throw Failure(
        TASKC_ERROR_WRONG_TYPE,
        fmt::format("the sensor `{}`, a `{}`, has {} x {} elements, and the host's has {} x {}",
                    sensor.name, sensor.type, target.rows, target.columns, rows, columns));
  }
  if (view.quaternions == TASKC_WXYZ || (view.quaternions == TASKC_XYZW && IsQuaternion(sensor)))
    return;
  throw Failure(TASKC_ERROR_WRONG_TYPE,
                fmt::format("the sensor `{}` is a `{}`, whose elements have no order {}",
                            sensor.name, sensor.type, view.quaternions));
}

// ---- Runs ---------------------------------------------------------------------------------------

// Where the numbers are, each as bytes from the first, row by row.
std::vector<ptrdiff_t> OffsetsOf(const taskc_sensor& sensor, const Target& target,
                                 const taskc_view& view, size_t size) {
  ptrdiff_t row_stride = view.row_stride;
  ptrdiff_t column_stride = view.column_stride;
  if (row_stride == 0 && column_stride == 0) {
    column_stride = static_cast<ptrdiff_t>(size);
    row_stride = column_stride * target.columns;
  }
  const bool turns = view.quaternions == TASKC_XYZW;
  const bool is_array = !IndexTypeOf(sensor).empty();
  std::vector<ptrdiff_t> offsets;
  for (taskc_uint32 row = 0; row < target.rows; ++row) {
    for (taskc_uint32 column = 0; column < target.columns; ++column) {
      // (w, x, y, z) are the elements 3, 0, 1, 2 of (x, y, z, w).
      const taskc_uint32 from_row = turns && !is_array ? (row + 3) % 4 : row;
      const taskc_uint32 from_column = turns && is_array ? (column + 3) % 4 : column;
      offsets.push_back(from_row * row_stride + from_column * column_stride);
    }
  }
  return offsets;
}

}  // namespace

Target FindTarget(const taskc_plugin& task, const char* name, const char* unit) {
  RequirePointer(name, "the name of the sensor");
  const std::string_view text = name;
  const size_t bracket = text.ends_with(']') ? text.find('[') : text.npos;
  const std::string sensor_name(text.substr(0, bracket));
  Target target{.sensor = IndexOf(task, SensorsOf(task), sensor_name.c_str(), "sensor")};
  const taskc_sensor& sensor = task.sensors[target.sensor];
  CheckUnit(unit, sensor.unit, sensor.name);
  target.rows = sensor.rows;
  target.columns = sensor.columns;
  if (bracket == text.npos) return target;
  target.first_row =
      RowOf(task, sensor, std::string(text.substr(bracket + 1, text.size() - bracket - 2)));
  target.rows = 1;
  target.is_entry = true;
  return target;
}

std::vector<Run> RunsOf(const taskc_plugin& task, const Target& target, const taskc_view& view,
                        ptrdiff_t time_stride, std::byte* to) {
  const taskc_sensor& sensor = task.sensors[target.sensor];
  RequirePointer(view.data, "the data of the view");
  CheckShape(sensor, target, view);
  const Format format = CheckedFormat(sensor, view);
  const std::vector<ptrdiff_t> offsets = OffsetsOf(sensor, target, view, format.size);
  std::vector<Run> runs;
  for (size_t i = 0; i < offsets.size();) {
    const ptrdiff_t stride = i + 1 < offsets.size() ? offsets[i + 1] - offsets[i] : 0;
    size_t end = i + 1;
    while (end < offsets.size() && offsets[end] - offsets[end - 1] == stride) ++end;
    runs.push_back({.from = static_cast<const std::byte*>(view.data) + offsets[i],
                    .time_stride = time_stride,
                    .stride = stride,
                    .count = end - i,
                    .to = to + i * host::ScalarSize(sensor.scalar),
                    .copy = format.copy});
    i = end;
  }
  return runs;
}

bool IsInPlace(const taskc_sensor& sensor, const taskc_view& view, const std::vector<Run>& runs) {
  const size_t size = host::ScalarSize(sensor.scalar);
  if (view.format != OwnFormat(sensor.scalar) || runs.size() != 1) return false;
  const Run& run = runs.front();
  return run.count == size_t{sensor.rows} * sensor.columns &&
         (run.count == 1 || run.stride == static_cast<ptrdiff_t>(size)) &&
         reinterpret_cast<uintptr_t>(run.from) % size == 0 &&
         run.time_stride % static_cast<ptrdiff_t>(size) == 0;
}

}  // namespace libtaskc
