#include "runtime/live/control/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runtime/base/suggestion.h"
#include "runtime/base/user_error.h"
#include "runtime/training/run/value_json.h"

namespace runtime {
namespace {

using enum ArgumentType;

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

const CommandSpec& FindCommand(std::span<const CommandSpec> commands, std::string_view name) {
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
