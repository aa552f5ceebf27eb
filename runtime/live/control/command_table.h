// All that a running trainer can be asked for: the one list that the server, its client and the
// documentation are made from.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string_view>

namespace runtime {

enum class ArgumentType { kText, kWhole, kNumber, kFlag, kValue, kObject };

struct ArgumentSpec {
  const char* name;
  ArgumentType type;
  bool is_required;
  const char* doc;
};

struct CommandSpec {
  const char* name;  // "module_add"; `trainer ctl module add`
  const char* doc;
  bool changes;  // whether it has an effect on the run; the others only look
  std::span<const ArgumentSpec> arguments;
};

std::span<const CommandSpec> Commands();

// Throws UserError for an unknown name, with the nearest one.
const CommandSpec& FindCommand(std::string_view name);

// Throws UserError where an argument is missing, unknown or of another type.
void CheckArguments(const CommandSpec& command, const nlohmann::json& arguments);

}  // namespace runtime
