// trainer ctl: talks to a running trainer. Its commands are those of the command table, `events`,
// `page` and `watch`.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "base/text/print.h"
#include "runtime/base/user_error.h"
#include "runtime/live/client/client.h"
#include "runtime/live/client/page_address.h"
#include "runtime/live/client/reply_text.h"
#include "runtime/live/control/command_table.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/ctl/arguments.h"
#include "runtime/trainer/ctl/options.h"

namespace runtime {
namespace {

using command_line::Command;
constexpr const char* kLookingGroup = "Commands that look at the run";
constexpr const char* kChangingGroup = "Commands that change the run";

constexpr const char* kExamples =
    "trainer ctl status\n"
    "trainer ctl load careful.task as careful      # evaluated beside the active task\n"
    "trainer ctl promote careful                   # the learner is paid by it from now on\n"
    "trainer ctl swap task crawling.task --now     # another task, between two time steps\n"
    "trainer ctl rollback task                     # or to any version: rollback task a1b2c3d4\n"
    "trainer ctl set task.fall_penalty 8\n"
    "trainer ctl set learner.temperature = 2 to 0.1 over 200 episodes\n"
    "trainer ctl watch crawling.task --now         # swaps whenever the file is saved\n"
    "trainer ctl events --json | jq .return";

using Options = std::shared_ptr<CtlOptions>;  // of the whole line

int AskAndPrint(const CtlOptions& options, const Request& request) {
  const Reply reply = Ask(options.FindRun(), request);
  if (options.json) {
    text::Print("{}\n", reply.ok ? nlohmann::json{{"ok", true}, {"value", reply.value}}.dump()
                                 : nlohmann::json{{"ok", false}, {"error", reply.error}}.dump());
  } else if (reply.ok) {
    text::Print("{}", ReplyText(reply.value));
  } else if (reply.error.find('\n') != std::string::npos) {
    text::Print(stderr, "{}\n", reply.error);  // the compiler's messages, as it writes them
  } else {
    throw UserError(reply.error);
  }
  return reply.ok ? kSuccess : kFailed;
}

Command& AddSubcommand(Command& ctl, const CommandSpec& spec) {
  const std::string name = CtlWords(spec);
  const size_t space = name.find(' ');
  if (space == std::string::npos) {
    Command& command = ctl.AddCommand(name, spec.doc);
    command.Group(spec.changes() ? kChangingGroup : kLookingGroup);
    return command;
  }
  const std::string first = name.substr(0, space);
  Command* parent = ctl.FindCommand(first);
  if (parent == nullptr) {
    parent = &ctl.AddCommand(first, "adds and removes modules");
    parent->Group(kChangingGroup);
  }
  return parent->AddCommand(name.substr(space + 1), spec.doc);
}

void AddSpecified(Command& ctl, const CommandSpec& spec, const Options& options) {
  Command& command = AddSubcommand(ctl, spec);
  options->AddTo(command);
  const auto request = std::make_shared<Request>(Request{spec.name, nlohmann::json::object()});
  AddCtlArguments(command, spec, request->arguments);
  command.OnRun([options, request] { return AskAndPrint(*options, *request); });
}

int PrintEvents(const CtlOptions& options) {
  FollowEvents(options.FindRun(), [&](const nlohmann::json& event) {
    text::Print("{}\n", options.json ? event.dump() : EventLine(event));
    std::fflush(stdout);
  });
  return kSuccess;
}

void AddEvents(Command& ctl, const Options& options) {
  Command& command =
      ctl.AddCommand("events", "prints events as they happen, until the trainer ends or Ctrl-C");
  command.Group(kLookingGroup);
  options->AddTo(command);
  command.OnRun([options] { return PrintEvents(*options); });
}

void AddPage(Command& ctl, const Options& options) {
  Command& command = ctl.AddCommand(
      "page", "prints the address of the page on which the run is watched and tuned");
  command.Group(kLookingGroup);
  options->AddTo(command);
  command.OnRun([options] {
    const std::string address = PageAddress(options->FindRun());
    text::Print("{}\n",
                options->json ? nlohmann::json{{"ok", true}, {"value", address}}.dump() : address);
    return kSuccess;
  });
}

}  // namespace

void AddCtlCommand(Command& program) {
  const auto options = std::make_shared<CtlOptions>();
  Command& ctl = program.AddCommand(
      "ctl", "Talks to a trainer while it trains: looks at the run and changes it.");
  options->AddTo(ctl);
  ctl.Examples(kExamples);
  ctl.Notes("Without --run it is the one run under runs/ that is being trained.");
  ctl.ExitStatus("0 success, 1 refused or no trainer is running, 2 the command line is wrong.");
  for (const CommandSpec& spec : Commands()) AddSpecified(ctl, spec, options);
  AddEvents(ctl, options);
  AddPage(ctl, options);
  AddCtlWatch(ctl, options);
}

}  // namespace runtime
