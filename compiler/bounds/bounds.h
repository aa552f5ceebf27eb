// How large and how small everything in a task can get: interval arithmetic over all its callbacks,
// from the ranges of the sensors and params.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/bounds/interval.h"
#include "compiler/bounds/values.h"
#include "compiler/check/checked_task.h"

namespace compiler {

// What keeps a value from having bounds.
struct Cause {
  enum Kind {
    kSensor,    // it has no range
    kParam,     // likewise
    kTimeStep,  // likewise
    kMemory,    // nothing bounds what is put into it
    kOperation  // a division by what may be 0, a logarithm, ...
  };
  Kind kind = kSensor;
  std::string name;  // of the sensor, param or memory; "a division by 0"
  Span span;         // where it is read
};

struct ValueBounds {
  Interval value = kNothing;  // nothing: never computed
  std::vector<Cause> causes;  // why it is unbounded
};

struct TermBounds {
  std::optional<Interval> rate;     // [1/s]; nothing: no `reward rate` that can run pays this term
  std::optional<Interval> payment;  // each time; nothing: no plain `reward` that can run does
  // The potential itself, not what it pays; nothing: the term is none.
  std::optional<Interval> potential;
  std::vector<Cause> causes;
};

// What a potential with these values pays for an action, whatever the discount and the end.
Interval PaymentOfPotential(const Interval& potential);

// The condition of an `if` or `require` that is reached. One in a loop counts once for all passes.
struct ConditionBounds {
  Span span;
  bool may_be_true = false;
  bool may_be_false = false;
  // What it compares, with the values that this can have there.
  struct Operand {
    Span span;
    Interval value;
    Unit unit;
  };
  std::vector<Operand> operands{};
};

// A call of a function of one number that has no value for some that its argument can have.
struct LeftDomain {
  Builtin function;
  Span argument;
  Interval value;  // of the argument
  Unit unit;
};

struct TaskBounds {
  std::vector<TermBounds> terms;     // as in the task
  std::vector<ValueBounds> metrics;  // whenever they are measured
  std::vector<ValueBounds> observations;
  std::vector<ValueBounds> logs;
  std::vector<Box> memory;  // between callbacks
  std::vector<bool> ends_reached;
  std::vector<ConditionBounds> conditions;
  std::vector<LeftDomain> left_domains;
};

// What is known of sensors and params beyond their ranges.
struct Assumptions {
  // What has no range (some sensors and params, perhaps the time step) is smaller than this.
  double without_range = kInfinity;
  // Sensors whose range is only claimed, see CheckedSensor::is_nominal, stay within this share of
  // it where it reaches equally far to both sides.
  double share_of_nominal = 1;
  bool has_initial_params = false;  // all params have their initial values
};

// Of a range that is claimed, a robot that moves as it should hardly uses more than this share: so
// much is what we call moderate motions.
inline constexpr double kModerateShare = 0.01;

TaskBounds ComputeBounds(const CheckedTask& task, const Assumptions& assumptions = {});

}  // namespace compiler
