// A command that a server takes, as data: what its clients, its checks and docs/api.md are made
// from.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>

namespace runtime {

// kTaskFile: a text, the file of a task, which is built and loaded before the command is done.
enum class ArgumentType { kText, kTaskFile, kWhole, kNumber, kFlag, kValue, kObject };

// Which part of a run a text is the name of.
enum class NamedPart { kNone, kModule, kTaskModule, kParameter, kModuleOrParameter, kGoal, kPort };

struct ArgumentSpec {
  const char* name;
  ArgumentType type;
  bool is_required;
  const char* doc;
  NamedPart names = NamedPart::kNone;
};

struct CommandSpec {
  const char* name;  // "module_add"; `trainer ctl module add`
  const char* doc;
  std::span<const ArgumentSpec> arguments;
  bool has_effect;

  // Whether it has an effect, or sets something to work; the others only look.
  bool changes() const { return has_effect; }
  // Null where it takes no file of a task.
  const ArgumentSpec* task_file() const;
};

// Throws UserError for an unknown name, with the nearest one.
const CommandSpec& FindCommand(std::span<const CommandSpec> commands, std::string_view name);

// Throws UserError where an argument is missing, unknown or of another type.
void CheckArguments(const CommandSpec& command, const nlohmann::json& arguments);

}  // namespace runtime
