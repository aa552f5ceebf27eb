// Functions of the past: `previous(x)`, `rate(x)`, `smooth(x, 0.1 s)`, `since(c)` and the like.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

struct TimeFunctionDescription {
  std::string_view name;
  TimeFunction function;
  std::string_view usage;  // "smooth(x, time)"
  std::string_view doc;
  bool takes_condition = false;
  bool takes_duration = false;
};
inline constexpr TimeFunctionDescription kTimeFunctions[] = {
    {"previous", TimeFunction::kPrevious, "previous(x)", "What `x` was a time step ago."},
    {"change", TimeFunction::kChange, "change(x)",
     "By how much `x` has changed since the time step before."},
    {"rate", TimeFunction::kRate, "rate(x)", "By how much `x` changes per second."},
    {"delay", TimeFunction::kDelay, "delay(x, time)",
     "What `x` was that long ago; instead of a time a number of time steps.", false, true},
    {"smooth", TimeFunction::kSmooth, "smooth(x, time)",
     "A running mean of `x`, in which what lies `time` back counts 37 % as much as the present.",
     false, true},
    {"held", TimeFunction::kHeld, "held(c, time)",
     "Whether the condition has been true without a break for that long.", true, true},
    {"since", TimeFunction::kSince, "since(c)",
     "How long the condition has not been true, or else since the start of the episode.", true},
    {"rising", TimeFunction::kRising, "rising(c)",
     "Whether the condition has become true in this time step.", true},
    {"falling", TimeFunction::kFalling, "falling(c)",
     "Whether the condition has become false in this time step.", true},
};

// The one of this name, or null.
const TimeFunctionDescription* FindTimeFunction(std::string_view name);
std::string_view NameOf(TimeFunction function);

// Those of a task, with the memory that they live in.
class TimeFunctionTable {
 public:
  // Refers to `task`, which must outlive this.
  explicit TimeFunctionTable(CheckedTask& task) : task_(task) {}

  // A call, as the read of what it gives; the same calls share one memory. Reports and returns
  // nothing where it is wrong.
  std::optional<CheckedExpression> Check(const TimeFunctionDescription& description,
                                         const CallExpression& call, Span span, const Place& place,
                                         const TaskScope& scope);

  // Brings all of them up to date: at the start of an episode, and at the end of each time step,
  // before the task's own blocks.
  void AddStatements();

 private:
  uint32_t Add(const TimeFunctionDescription& description, CheckedExpression argument,
               std::optional<CheckedExpression> duration, uint32_t steps, Span span);
  uint32_t AddMemory(std::string name, const Type& type, Unit unit, Span span);
  std::optional<uint32_t> FindSame(TimeFunction function, const CheckedExpression& argument,
                                   const std::optional<CheckedExpression>& duration) const;

  struct Arguments {
    CheckedExpression value;
    std::optional<CheckedExpression> duration;
  };
  CheckedTask& task_;
  std::vector<Arguments> arguments_;  // of each of the task's time functions
};

}  // namespace compiler
