// What a running trainer can be asked for: the rows of command_table.def.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>
#include <variant>

namespace runtime {

class LiveRun;
struct QueuedRequest;

// kTaskFile: a text, the file of a task, which is built and loaded before the handler is called.
enum class ArgumentType { kText, kTaskFile, kWhole, kNumber, kFlag, kValue, kObject };

struct ArgumentSpec {
  const char* name;
  ArgumentType type;
  bool is_required;
  const char* doc;
};

// The kinds of handlers, as command_table.def says.
using LookHandler = nlohmann::json (LiveRun::*)(const nlohmann::json& arguments) const;
using ChangeHandler = nlohmann::json (LiveRun::*)(const QueuedRequest& request);
using LateHandler = void (LiveRun::*)(const QueuedRequest& request);
using CommandHandler = std::variant<LookHandler, ChangeHandler, LateHandler>;

struct CommandSpec {
  const char* name;  // "module_add"; `trainer ctl module add`
  const char* doc;
  std::span<const ArgumentSpec> arguments;
  CommandHandler handler;

  // Whether it has an effect on the run; the others only look.
  bool changes() const { return !std::holds_alternative<LookHandler>(handler); }
  // Null where it takes no file of a task.
  const ArgumentSpec* task_file() const;
};

std::span<const CommandSpec> Commands();

// Throws UserError for an unknown name, with the nearest one.
const CommandSpec& FindCommand(std::string_view name);

// Throws UserError where an argument is missing, unknown or of another type.
void CheckArguments(const CommandSpec& command, const nlohmann::json& arguments);

}  // namespace runtime
