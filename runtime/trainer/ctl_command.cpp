// trainer ctl: talks to a running trainer. Its commands are those of the command table, and what is
// made of them.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "runtime/client/client.h"
#include "runtime/client/reply_text.h"
#include "runtime/client/set_words.h"
#include "runtime/control/command_table.h"
#include "runtime/module/user_error.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/ctl_options.h"

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
    "  trainer ctl rollback task\n"
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
    fmt::print("{}\n", reply.ok ? json{{"ok", true}, {"value", reply.value}}.dump()
                                : json{{"ok", false}, {"error", reply.error}}.dump());
  } else if (reply.ok) {
    fmt::print("{}", ReplyText(reply.value));
  } else if (reply.error.find('\n') != std::string::npos) {
    fmt::print(stderr, "{}\n", reply.error);  // the compiler's messages, as it writes them
  } else {
    throw UserError(reply.error);
  }
  return reply.ok ? kSuccess : kFailed;
}

std::string UpperCase(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char byte) { return std::toupper(byte); });
  return text;
}

// The trainer may have been started in another folder.
std::string Absolute(const std::string& file) {
  return std::filesystem::absolute(file).lexically_normal().string();
}

template <class Value, class Set>
void AddValue(CLI::App& command, const ArgumentSpec& spec, const Set& set) {
  const std::string word = UpperCase(spec.name);
  command
      .add_option_function<Value>(spec.is_required ? word : std::string("--") + spec.name, set,
                                  spec.doc)
      ->required(spec.is_required)
      ->type_name(spec.is_required ? "" : word);
}

// A required argument stands without its name, the others are options.
void AddArgument(CLI::App& command, const ArgumentSpec& spec, json& arguments) {
  const std::string name = spec.name;
  const auto set = [&arguments, name](const auto& value) { arguments[name] = value; };
  switch (spec.type) {
    case ArgumentType::kFlag:
      command.add_flag_callback(
          "--" + name, [set] { set(true); }, spec.doc);
      break;
    case ArgumentType::kText:
      AddValue<std::string>(command, spec, [set, name](const std::string& word) {
        set(name == "file" ? Absolute(word) : word);
      });
      break;
    case ArgumentType::kWhole:
      AddValue<int64_t>(command, spec, set);
      break;
    case ArgumentType::kNumber:
      AddValue<double>(command, spec, set);
      break;
    case ArgumentType::kValue:
    case ArgumentType::kObject:
      AddValue<std::string>(command, spec,
                            [set](const std::string& word) { set(ValueOfWord(word)); });
      break;
  }
}

void DeclareByTable(CLI::App& command, const CommandSpec& spec, json& arguments) {
  for (const ArgumentSpec& argument : spec.arguments) AddArgument(command, argument, arguments);
}

// load FILE [as NAME]
void DeclareLoad(CLI::App& command, const CommandSpec& spec, json& arguments) {
  AddArgument(command, spec.arguments[0], arguments);
  const auto set_name = [&arguments](const std::string& name) { arguments["name"] = name; };
  const auto set_words = [set_name](const std::vector<std::string>& words) {
    if (words.front() != "as") {
      throw CLI::ValidationError("`" + words.front() + "`: write `as NAME`");
    }
    set_name(words.back());
  };
  const char* doc = spec.arguments[1].doc;
  command.add_option_function<std::vector<std::string>>("as NAME", set_words, doc)
      ->expected(2)
      ->type_name("");
  command.add_option_function<std::string>("--as", set_name, doc)->type_name("NAME");
}

// set NAME VALUE; what follows may begin with `-`, or be an arrow.
void DeclareSet(CLI::App& command, const CommandSpec&, json& arguments) {
  command.allow_extras();
  command.footer(
      "  trainer ctl set NAME VALUE\n"
      "  trainer ctl set NAME = FROM to TO over N episodes\n"
      "A value may have a unit: `20 s`. For `to` there may stand → or, in quotes, `->`.");
  command.parse_complete_callback([&command, &arguments] {
    try {
      arguments = SetArguments(command.remaining());
    } catch (const UserError& error) {
      throw CLI::ValidationError(error.what());
    }
  });
}

// step [COUNT] [--episodes]
void DeclareStep(CLI::App& command, const CommandSpec& spec, json& arguments) {
  const auto set_count = [&arguments](int64_t count) { arguments["count"] = count; };
  command.add_option_function<int64_t>("COUNT", set_count, spec.arguments[0].doc)->type_name("");
  command.add_flag_callback(
      "--episodes", [&arguments] { arguments["unit"] = "episode"; },
      "episodes; otherwise time steps");
}

// module add TYPE NAME [PARAMETER=VALUE...]
void DeclareModuleAdd(CLI::App& command, const CommandSpec& spec, json& arguments) {
  AddArgument(command, spec.arguments[0], arguments);
  AddArgument(command, spec.arguments[1], arguments);
  const auto set_parameters = [&arguments](const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) {
      const size_t equals = setting.find('=');
      if (equals == std::string::npos) {
        throw CLI::ValidationError("`" + setting + "`: write `PARAMETER=VALUE`");
      }
      arguments["parameters"][setting.substr(0, equals)] = ValueOfWord(setting.substr(equals + 1));
    }
  };
  command
      .add_option_function<std::vector<std::string>>("PARAMETER=VALUE", set_parameters,
                                                     spec.arguments[2].doc)
      ->type_name("");
}

// Commands that are not written as the table says.
struct Special {
  std::string_view command;
  void (*declare)(CLI::App& command, const CommandSpec& spec, json& arguments);
};
constexpr Special kSpecial[] = {{"load", DeclareLoad},
                                {"set", DeclareSet},
                                {"step", DeclareStep},
                                {"module_add", DeclareModuleAdd}};

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
  const auto special = std::ranges::find(kSpecial, std::string_view(spec.name), &Special::command);
  const auto declare = special == std::end(kSpecial) ? DeclareByTable : special->declare;
  declare(*command, spec, request->arguments);
  command->callback([options, request, &status] { status = AskAndPrint(*options, *request); });
}

void AddEvents(CLI::App& ctl, const Options& options, int& status) {
  CLI::App* command = ctl.add_subcommand(
      "events", "prints what happens, as it happens, until the trainer ends or Ctrl-C");
  command->group(kLookingGroup);
  options->AddTo(*command);
  command->callback([options, &status] {
    FollowEvents(options->FindRun(), [&](const json& event) {
      fmt::print("{}\n", options->json ? event.dump() : EventLine(event));
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
  AddCtlWatch(*ctl, options, status);
  ctl->footer(kExamples);  // last, because subcommands take over what there is
}

}  // namespace runtime
