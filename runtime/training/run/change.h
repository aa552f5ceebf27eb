// What was changed in a run while it learned: a plain struct for each kind of change. How they are
// written in the run's record stands in change_json.cpp, how a person reads them in
// change_text.cpp.
//
// Whoever asks something of a change says what holds for each kind, by std::visit without a case
// for the rest (base/variant/overloaded.h): where a new kind was forgotten, that does not compile.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "runtime/core/module/module.h"

namespace runtime {

// Another task in a task module. `forget`: what was learned.
struct SwapTask {
  static constexpr std::string_view kKind = "swap";
  std::string module;
  int64_t task = 0;  // TaskRecord::id of the one that comes
  bool forget = false;
};

// A new task module, which is evaluated beside the active one.
struct LoadShadow {
  static constexpr std::string_view kKind = "load";
  std::string module;
  int64_t task = 0;  // TaskRecord::id
};

// A task that the module has had before.
struct RollBackTask {
  static constexpr std::string_view kKind = "rollback";
  std::string module;
  int64_t task = 0;  // TaskRecord::id of the one that comes back
};

// The learner is paid by this task module from now on.
struct PromoteTask {
  static constexpr std::string_view kKind = "promote";
  std::string module;
  bool forget = false;
};

struct UnloadShadow {
  static constexpr std::string_view kKind = "unload";
  std::string module;
};

struct SetParameter {
  static constexpr std::string_view kKind = "set";
  std::string parameter;  // "task.weight"
  ParameterValue value;
};

// A number as a client has written it: 2 or 2.0.
using WrittenNumber = std::variant<int64_t, double>;
double AsReal(const WrittenNumber& number);

// A parameter that goes from one value to another, episode by episode.
struct ScheduleParameter {
  static constexpr std::string_view kKind = "set";
  std::string parameter;
  WrittenNumber from;
  WrittenNumber to;
  int64_t episodes = 1;
};

// A goal that is told by a client from then on, and no more drawn by the task.
struct HoldGoal {
  static constexpr std::string_view kKind = "hold";
  std::string goal;  // "task.velocity"
  ParameterValue value;
};

struct ReleaseGoal {
  static constexpr std::string_view kKind = "release";
  std::string goal;  // "task.velocity"
};

// Of two ports: "task.reward".
struct ConnectPorts {
  static constexpr std::string_view kKind = "connect";
  std::string first;
  std::string second;
};

struct DisconnectPorts {
  static constexpr std::string_view kKind = "disconnect";
  std::string first;
  std::string second;
};

struct AddModule {
  static constexpr std::string_view kKind = "module_add";
  std::string type;
  std::string module;
  std::vector<std::pair<std::string, ParameterValue>> parameters;
};

struct RemoveModule {
  static constexpr std::string_view kKind = "module_remove";
  std::string module;
};

// A task, or one change, has done harm and is never run, or done, again.
struct PutInQuarantine {
  static constexpr std::string_view kKind = "quarantine";
  std::optional<int64_t> task;    // TaskRecord::id
  std::optional<int64_t> change;  // ChangeRecord::id
  std::string why;
};

// Of a kind that only another version of the trainer knows.
struct UnknownChange {
  std::string kind;
  std::string data;  // as it stands in the record
};

using Change =
    std::variant<SwapTask, LoadShadow, RollBackTask, PromoteTask, UnloadShadow, SetParameter,
                 ScheduleParameter, HoldGoal, ReleaseGoal, ConnectPorts, DisconnectPorts, AddModule,
                 RemoveModule, PutInQuarantine, UnknownChange>;

// "swap"
std::string_view KindOf(const Change& change);

struct TaskOfModule {
  std::string module;
  int64_t task = 0;  // TaskRecord::id
};
// The task that a change brings into the graph, and where.
std::optional<TaskOfModule> TaskBroughtBy(const Change& change);

// Whether the learner may be paid by another task from then on, or by `module` with other params.
bool ChangesReward(const Change& change, std::string_view module);

}  // namespace runtime
