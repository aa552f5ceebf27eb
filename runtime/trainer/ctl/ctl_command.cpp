// trainer ctl: talks to a running trainer. Its commands are those of the command table, `events`
// and `watch`.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "base/text/print.h"
#include "runtime/base/user_error.h"
#include "runtime/live/client/client.h"
#include "runtime/live/client/reply_text.h"
#include "runtime/live/control/command_table.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/ctl/arguments.h"
#include "runtime/trainer/ctl/options.h"

namespace runtime {
namespace {

using nlohmann::json;

constexpr const char* kLookingGroup = "Commands that look";
constexpr const char* kChangingGroup = "Commands that change the run";

constexpr const char* kExamples =
    "Examples:\n"
    "  trainer ctl status\n"
    "  trainer ctl load careful.task as careful      # evaluated beside the active task\n"
    "  trainer ctl promote careful                   # the learner is paid by it from now on\n"
    "  trainer ctl swap task crawling.task --now     # another task, between two time steps\n"
    "  trainer ctl rollback task                     # or to any version: rollback task a1b2c3d4\n"
    "  trainer ctl set task.fall_penalty 8\n"
    "  trainer ctl set learner.temperature = 2 to 0.1 over 200 episodes\n"
    "  trainer ctl watch crawling.task --now         # swaps whenever the file is saved\n"
    "  trainer ctl events --json | jq .return\n"
    "Without --run it is the one run under runs/ on which a trainer is at work.\n"
    "Exit status: 0 done, 1 refused or no trainer there, 2 wrong call.";

using Options = std::shared_ptr<CtlOptions>;  // of the whole line

int AskAndPrint(const CtlOptions& options, const Request& request) {
  const Reply reply = Ask(options.FindRun(), request);
  if (options.json) {
    text::Print("{}\n", reply.ok ? json{{"ok", true}, {"value", reply.value}}.dump()
                                 : json{{"ok", false}, {"error", reply.error}}.dump());
  } else if (reply.ok) {
    text::Print("{}", ReplyText(reply.value));
  } else if (reply.error.find('\n') != std::string::npos) {
    text::Print(stderr, "{}\n", reply.error);  // the compiler's messages, as it writes them
  } else {
    throw UserError(reply.error);
  }
  return reply.ok ? kSuccess : kFailed;
}

// "module_add" is `module add`.
CLI::App* AddSubcommand(CLI::App& ctl, const std::string& name, const std::string& doc) {
  const size_t underscore = name.find('_');
  if (underscore == std::string::npos) return ctl.add_subcommand(name, doc);
  const std::string first = name.substr(0, underscore);
  const auto there =
      ctl.get_subcommands([&](const CLI::App* command) { return command->get_name() == first; });
  CLI::App* parent =
      there.empty() ? ctl.add_subcommand(first, "adds and removes modules") : there.front();
  parent->require_subcommand(1);
  parent->group(kChangingGroup);
  return parent->add_subcommand(name.substr(underscore + 1), doc);
}

void AddCommand(CLI::App& ctl, const CommandSpec& spec, const Options& options, int& status) {
  CLI::App* command = AddSubcommand(ctl, spec.name, spec.doc);
  if (command->get_parent() == &ctl) {
    command->group(spec.changes ? kChangingGroup : kLookingGroup);
  }
  options->AddTo(*command);
  const auto request = std::make_shared<Request>(Request{spec.name, json::object()});
  AddCtlArguments(*command, spec, request->arguments);
  command->callback([options, request, &status] { status = AskAndPrint(*options, *request); });
}

void AddEvents(CLI::App& ctl, const Options& options, int& status) {
  CLI::App* command = ctl.add_subcommand(
      "events", "prints what happens, as it happens, until the trainer ends or Ctrl-C");
  command->group(kLookingGroup);
  options->AddTo(*command);
  command->callback([options, &status] {
    FollowEvents(options->FindRun(), [&](const json& event) {
      text::Print("{}\n", options->json ? event.dump() : EventLine(event));
      std::fflush(stdout);
    });
    status = kSuccess;
  });
}

}  // namespace

void AddCtlCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<CtlOptions>();
  CLI::App* ctl = app.add_subcommand("ctl", "Talks to a trainer while it trains.");
  ctl->require_subcommand(1);
  options->AddTo(*ctl);
  for (const CommandSpec& command : Commands()) AddCommand(*ctl, command, options, status);
  AddEvents(*ctl, options, status);
  AddCtlWatch(*ctl, options);
  ctl->footer(kExamples);  // last, because subcommands take over what there is
}

}  // namespace runtime
