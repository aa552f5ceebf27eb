#include "runtime/live/control/command_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runtime/base/suggestion.h"
#include "runtime/base/user_error.h"
#include "runtime/live/control/live_run.h"
#include "runtime/training/run/value_json.h"

namespace runtime {
namespace {

using enum ArgumentType;

constexpr bool kRequired = true;
constexpr bool kOptional = false;

// What several commands take.
constexpr ArgumentSpec kTaskModule = {"name", kText, kRequired, "name of the task module"};
constexpr ArgumentSpec kFileOfTask = {"file", kTaskFile, kRequired,
                                      "a .task file, or a .so built by taskc"};
constexpr ArgumentSpec kTextOfTask = {"text", kText, kOptional,
                                      "what is built in the place of what the .task file holds"};
constexpr ArgumentSpec kNow = {"now", kFlag, kOptional,
                               "between two time steps; by default when the next episode starts"};
constexpr ArgumentSpec kForget = {"forget", kFlag, kOptional,
                                  "forget what was learned and start over"};
constexpr ArgumentSpec kFirstPort = {"first", kText, kRequired, "a port: `task.reward`"};
constexpr ArgumentSpec kSecondPort = {"second", kText, kRequired,
                                      "a port that fits it: `learner.reward`"};

using ArgumentList = std::initializer_list<ArgumentSpec>;

// kArgumentsOfSwap, and so on.
#define LOOK(handler, name, doc, ...) constexpr ArgumentList kArgumentsOf##handler = {__VA_ARGS__};
#define CHANGE LOOK
#define CHANGE_LATER LOOK
#include "runtime/live/control/command_table.def"

constexpr std::span<const ArgumentSpec> SpanOf(ArgumentList list) {
  return {list.begin(), list.size()};
}

bool Fits(const nlohmann::json& value, ArgumentType type) {
  switch (type) {
    case kText:
    case kTaskFile:
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
    case kTaskFile:
      return "a string";
    case kWhole:
      return "an integer";
    case kNumber:
      return "a number";
    case kFlag:
      return "true or false";
    case kValue:
      return "a number, a boolean, a string or a list of numbers";
    case kObject:
      return "an object";
  }
  return "";
}

}  // namespace

const ArgumentSpec* CommandSpec::task_file() const {
  const auto found = std::ranges::find(arguments, kTaskFile, &ArgumentSpec::type);
  return found == arguments.end() ? nullptr : &*found;
}

std::span<const CommandSpec> Commands() {
  static constexpr CommandSpec kCommands[] = {
#define LOOK(handler, name, doc, ...) {name, doc, SpanOf(kArgumentsOf##handler), &LiveRun::handler},
#define CHANGE LOOK
#define CHANGE_LATER LOOK
#include "runtime/live/control/command_table.def"
  };
  return kCommands;
}

const CommandSpec& FindCommand(std::string_view name) {
  const std::span<const CommandSpec> commands = Commands();
  const auto found = std::ranges::find(commands, name, &CommandSpec::name);
  if (found != commands.end()) return *found;
  std::vector<std::string> names;
  for (const CommandSpec& command : commands) names.emplace_back(command.name);
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
