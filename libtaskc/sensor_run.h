// Numbers in a host's memory, and how they become those that a task reads.
#pragma once

#include <taskc/host.h>

#include <cstddef>
#include <string_view>
#include <vector>

namespace libtaskc {

// Numbers at equal distances that go into as many elements of a sensor, which are side by side.
struct Run {
  using Copy = void (*)(const std::byte* from, ptrdiff_t stride, size_t count, std::byte* to);

  const std::byte* from = nullptr;
  ptrdiff_t time_stride = 0;  // to the same number a time step later [bytes]
  ptrdiff_t stride = 0;       // from one number to the next [bytes]
  size_t count = 0;
  std::byte* to = nullptr;
  Copy copy = nullptr;

  void CopyAt(ptrdiff_t row) const { copy(from + row * time_stride, stride, count, to); }
};

// A sensor, or one entry of it: so many rows of it, from `first_row` on.
struct Target {
  size_t sensor = 0;
  taskc_uint32 first_row = 0;
  taskc_uint32 rows = 1;
  taskc_uint32 columns = 1;
  bool is_entry = false;
};

// "joint.angle", or "joint.angle[left_knee]", or "joint.angle[3]". Throws Failure.
Target FindTarget(const taskc_plugin& task, const char* name, const char* unit);

// What of `view` goes where in `target`, whose elements begin at `to`. Throws Failure for a view
// that is of another shape or has a format that the sensor cannot take.
std::vector<Run> RunsOf(const taskc_plugin& task, const Target& target, const taskc_view& view,
                        ptrdiff_t time_stride, std::byte* to);

// Whether the task can read the numbers where they are.
bool IsInPlace(const taskc_sensor& sensor, const taskc_view& view, const std::vector<Run>& runs);

}  // namespace libtaskc
