#include "runtime/live/control/command_table.h"

#include <initializer_list>

#include "runtime/live/control/live_run.h"

namespace runtime {
namespace {

using enum ArgumentType;

constexpr bool kRequired = true;
constexpr bool kOptional = false;

// What several commands take.
constexpr ArgumentSpec kTaskModule = {"name", kText, kRequired, "name of the task module",
                                      NamedPart::kTaskModule};
constexpr ArgumentSpec kFileOfTask = {"file", kTaskFile, kRequired,
                                      "a .task file, or a .so built by taskc"};
constexpr ArgumentSpec kTextOfTask = {"text", kText, kOptional,
                                      "what is built in the place of what the .task file holds"};
constexpr ArgumentSpec kNow = {"now", kFlag, kOptional,
                               "between two time steps; by default when the next episode starts"};
constexpr ArgumentSpec kForget = {"forget", kFlag, kOptional,
                                  "forget what was learned and start over"};
constexpr ArgumentSpec kFirstPort = {"first", kText, kRequired, "a port: `task.reward`",
                                     NamedPart::kPort};
constexpr ArgumentSpec kSecondPort = {"second", kText, kRequired,
                                      "a port that fits it: `learner.reward`", NamedPart::kPort};

using ArgumentList = std::initializer_list<ArgumentSpec>;

// kArgumentsOfSwap, and so on.
#define LOOK(handler, name, doc, ...) constexpr ArgumentList kArgumentsOf##handler = {__VA_ARGS__};
#define ASIDE LOOK
#define CHANGE LOOK
#define CHANGE_LATER LOOK
#include "runtime/live/control/command_table.def"

constexpr std::span<const ArgumentSpec> SpanOf(ArgumentList list) {
  return {list.begin(), list.size()};
}

}  // namespace

std::span<const CommandSpec> Commands() {
  static constexpr CommandSpec kCommands[] = {
#define LOOK(handler, name, doc, ...) {name, doc, SpanOf(kArgumentsOf##handler), false},
#define CHANGE(handler, name, doc, ...) {name, doc, SpanOf(kArgumentsOf##handler), true},
#define ASIDE CHANGE
#define CHANGE_LATER CHANGE
#include "runtime/live/control/command_table.def"
  };
  return kCommands;
}

const CommandSpec& FindCommand(std::string_view name) { return FindCommand(Commands(), name); }

const CommandHandler& HandlerOf(const CommandSpec& command) {
  static constexpr CommandHandler kHandlers[] = {
#define LOOK(handler, ...) &LiveRun::handler,
#define ASIDE LOOK
#define CHANGE LOOK
#define CHANGE_LATER LOOK
#include "runtime/live/control/command_table.def"
  };
  return kHandlers[&command - Commands().data()];
}

std::span<const CommandSpec> RequestHandler::commands() const { return Commands(); }

}  // namespace runtime
