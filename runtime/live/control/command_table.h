// What the trainer of a run can be asked for: the rows of command_table.def.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>
#include <variant>

#include "runtime/live/control/command.h"

namespace runtime {

struct BuiltPlugin;
class LiveRun;
struct QueuedRequest;

// The kinds of handlers, as command_table.def says.
using LookHandler = nlohmann::json (LiveRun::*)(const nlohmann::json& arguments) const;
using AsideHandler = nlohmann::json (LiveRun::*)(const nlohmann::json& arguments,
                                                 const BuiltPlugin& task);
using ChangeHandler = nlohmann::json (LiveRun::*)(const QueuedRequest& request);
using LateHandler = void (LiveRun::*)(const QueuedRequest& request);
using CommandHandler = std::variant<LookHandler, AsideHandler, ChangeHandler, LateHandler>;

std::span<const CommandSpec> Commands();

// Throws UserError for an unknown name, with the nearest one.
const CommandSpec& FindCommand(std::string_view name);

// `command`: one of Commands().
const CommandHandler& HandlerOf(const CommandSpec& command);

}  // namespace runtime
