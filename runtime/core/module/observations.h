// How what a task observes gets to a learner.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/core/module/port.h"

namespace runtime {

// One of the things that a learner sees: some numbers of a vector, one after the other.
struct ObservedValue {
  std::string name;
  std::string type;  // as the task language writes it: "vec3", "real[joint]"
  std::string unit;  // "m/s"; "" for a plain number
  size_t size = 1;   // how many numbers it is
  // Of each number, as far as its author and the robot's say; infinite where they say nothing.
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
};

// What a vector consists of, in its order.
struct ObservationLayout {
  std::vector<ObservedValue> values;

  size_t size() const {
    size_t size = 0;
    for (const ObservedValue& value : values) size += value.size;
    return size;
  }
};

// Throws UserError, which calls it `what`, unless its values have the names, types and units of
// those of `expected`: what was learned from one of the two says nothing about the other.
void CheckSameLayout(const ObservationLayout& expected, const ObservationLayout& layout,
                     const std::string& what);

class Module;

// What an out port of the module says that it shows a learner; nothing where it has no such port,
// or has not been connected to all that it needs.
std::optional<ObservationLayout> LayoutShownBy(const Module& module);

// Of one task.
class TaskObservations {
 public:
  virtual ~TaskObservations() = default;

  // Empty: the task observes nothing.
  virtual ObservationLayout observation_layout() const = 0;
  // The numbers as of now, all finite. Only while an episode runs, once the task has heard of its
  // start; valid until the next call, or until the task changes.
  virtual std::span<const double> Observe() const = 0;
};

template <>
struct TypeText<TaskObservations> {
  static constexpr const char* value = "task observations";
};
template <>
struct TypeText<ObservationLayout> {
  static constexpr const char* value = "observation layout";
};

}  // namespace runtime
