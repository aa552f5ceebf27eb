#include "runtime/live/control/command_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "runtime/base/suggestion.h"
#include "runtime/base/user_error.h"
#include "runtime/training/run/value_json.h"

namespace runtime {
namespace {

using enum ArgumentType;

constexpr bool kRequired = true;
constexpr bool kOptional = false;
constexpr bool kChanges = true;
constexpr bool kLooks = false;

constexpr ArgumentSpec kTaskModule = {"name", kText, kRequired, "name of the task module"};
constexpr ArgumentSpec kTaskFile = {"file", kText, kRequired,
                                    "a .task file, or a .so built by taskc"};
constexpr ArgumentSpec kNow = {"now", kFlag, kOptional,
                               "between two time steps; by default when the next episode starts"};
constexpr ArgumentSpec kForget = {"forget", kFlag, kOptional,
                                  "forget what was learned and start over"};

constexpr ArgumentSpec kLoad[] = {
    kTaskFile, {"name", kText, kOptional, "name of the new task module; by default the task's"}};
constexpr ArgumentSpec kSwap[] = {kTaskModule, kTaskFile, kNow, kForget};
constexpr ArgumentSpec kUnload[] = {kTaskModule};
constexpr ArgumentSpec kRollback[] = {kTaskModule,
                                      {"version", kText, kOptional,
                                       "a version that the module has had: its number, or the "
                                       "beginning of its hash; by default the previous one"},
                                      kNow};
constexpr ArgumentSpec kPromote[] = {kTaskModule, kNow, kForget};
constexpr ArgumentSpec kGet[] = {
    {"name", kText, kRequired, "`task.weight`, or `task` for all parameters of a module"}};
constexpr ArgumentSpec kSet[] = {
    {"name", kText, kRequired, "`task.weight`"},
    {"value", kValue, kOptional, "the new value; a string may have a unit: \"20 s\""},
    {"from", kNumber, kOptional, "of a schedule: the value in the next episode"},
    {"to", kNumber, kOptional, "of a schedule: the value in its last episode"},
    {"episodes", kWhole, kOptional, "of a schedule: how many episodes it takes"}};
constexpr ArgumentSpec kConnect[] = {
    {"first", kText, kRequired, "a port: `task.reward`"},
    {"second", kText, kRequired, "a port that fits it: `learner.reward`"}};
constexpr ArgumentSpec kModuleAdd[] = {
    {"type", kText, kRequired, "type of the module"},
    {"name", kText, kRequired, "name of the new module"},
    {"parameters", kObject, kOptional, "values of its parameters"}};
constexpr ArgumentSpec kModuleRemove[] = {{"name", kText, kRequired, "name of the module"}};
constexpr ArgumentSpec kResume[] = {
    {"episodes", kWhole, kOptional, "how many episodes the run is to have in total"}};
constexpr ArgumentSpec kStep[] = {
    {"count", kWhole, kOptional, "how many; by default 1"},
    {"unit", kText, kOptional, "`step` (a time step) or `episode`; by default `step`"}};
constexpr ArgumentSpec kGraph[] = {
    {"format", kText, kOptional, "`text`, `json` or `dot`; by default `text`"}};

constexpr CommandSpec kCommands[] = {
    {"status", "what the run is doing", kLooks, {}},
    {"list", "the task modules with their parameters, and all other modules", kLooks, {}},
    {"get", "a parameter, or all parameters of a module", kLooks, kGet},
    {"graph", "the modules and how their ports are connected", kLooks, kGraph},
    {"load", "evaluates another task beside the active one, as its shadow", kChanges, kLoad},
    {"swap", "replaces the task of a task module", kChanges, kSwap},
    {"rollback", "returns to the task before the last swap, or to any earlier one", kChanges,
     kRollback},
    {"unload", "removes a shadow", kChanges, kUnload},
    {"promote", "makes a shadow the active task, and the active one a shadow", kChanges, kPromote},
    {"set", "changes a parameter, at once or gradually over episodes", kChanges, kSet},
    {"connect", "connects two ports", kChanges, kConnect},
    {"disconnect", "disconnects two ports", kChanges, kConnect},
    {"module_add", "adds a module", kChanges, kModuleAdd},
    {"module_remove", "removes a module", kChanges, kModuleRemove},
    {"pause", "pauses after the current time step", kChanges, {}},
    {"resume", "continues after a pause", kChanges, kResume},
    {"step", "runs a few time steps or episodes, then pauses", kChanges, kStep},
    {"save", "writes a checkpoint when the current episode is over", kChanges, {}},
    {"stop", "ends the trainer after the current episode", kChanges, {}},
};

bool Fits(const nlohmann::json& value, ArgumentType type) {
  switch (type) {
    case kText:
      return value.is_string();
    case kWhole:
      return IsInt64(value);
    case kNumber:
      return value.is_number();
    case kFlag:
      return value.is_boolean();
    case kValue:
      return value.is_primitive() ? !value.is_null() : value.is_array();
    case kObject:
      return value.is_object();
  }
  return false;
}

const char* Wanted(ArgumentType type) {
  switch (type) {
    case kText:
      return "a text";
    case kWhole:
      return "a whole number";
    case kNumber:
      return "a number";
    case kFlag:
      return "true or false";
    case kValue:
      return "a number, a truth value, a text or a list of numbers";
    case kObject:
      return "an object";
  }
  return "";
}

}  // namespace

std::span<const CommandSpec> Commands() { return kCommands; }

const CommandSpec& FindCommand(std::string_view name) {
  const auto found = std::ranges::find(kCommands, name, &CommandSpec::name);
  if (found != std::end(kCommands)) return *found;
  std::vector<std::string> names;
  for (const CommandSpec& command : kCommands) names.emplace_back(command.name);
  throw UserError(fmt::format("there is no command `{}`{}", name, Suggestion(name, names)));
}

void CheckArguments(const CommandSpec& command, const nlohmann::json& arguments) {
  if (!arguments.is_object()) {
    throw UserError(fmt::format("the arguments of `{}` must be a JSON object", command.name));
  }
  for (const ArgumentSpec& spec : command.arguments) {
    const auto found = arguments.find(spec.name);
    if (found == arguments.end()) {
      if (!spec.is_required) continue;
      throw UserError(
          fmt::format("`{}` needs the argument `{}`: {}", command.name, spec.name, spec.doc));
    }
    if (Fits(*found, spec.type)) continue;
    throw UserError(fmt::format("the argument `{}` of `{}` must be {}", spec.name, command.name,
                                Wanted(spec.type)));
  }
  for (const auto& [name, value] : arguments.items()) {
    if (std::ranges::find(command.arguments, std::string_view(name), &ArgumentSpec::name) !=
        command.arguments.end()) {
      continue;
    }
    std::vector<std::string> names;
    for (const ArgumentSpec& spec : command.arguments) names.emplace_back(spec.name);
    throw UserError(
        fmt::format("`{}` has no argument `{}`{}", command.name, name, Suggestion(name, names)));
  }
}

}  // namespace runtime
