#include "compiler/driver/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "base/command_line/wrong_call.h"
#include "compiler/driver/crash_report.h"
#include "compiler/driver/print_error.h"
#include "compiler/driver/session.h"
#include "compiler/driver/verb.h"
#include "compiler/toolchain/internal_error.h"
#include "plugins/robot/robot_description.h"

namespace compiler {
namespace {

constexpr const char* kDescription =
    "Compiles tasks for robots that learn: .task files become plugins for the trainer.";

constexpr const char* kFooter =
    "`taskc VERB --help` tells more of a verb.\n"
    "Environment: CXX, the C++ compiler; TASKC_CACHE, the folder of built plugins;\n"
    "TASKC_ROBOT_PATH, folders with robots; NO_COLOR, no colors.\n"
    "Exit status: 0 fine, 1 the task has errors, 2 the call is wrong, 3 an error in taskc.";

constexpr const char* kVersion = "taskc " TASKC_VERSION;

// "Examples:" and the verb's, indented.
std::string Examples(const Verb& verb) {
  std::string text = "Examples:\n  ";
  for (const char* at = verb.examples; *at != '\0'; ++at) {
    text += *at;
    if (*at == '\n') text += "  ";
  }
  return text;
}

Action Declare(const Verb& verb, CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand(verb.name, verb.title);
  command->set_version_flag("--version", kVersion);
  command->footer(Examples(verb));
  return verb.declare(*command, session);
}

// A mistake of ours; `folder` may hold evidence of it already.
void ReportMistake(const std::string& message, const std::filesystem::path& folder,
                   Session& session) {
  WriteCrashReport(folder, message);
  session.Fail(fmt::format("internal error: {}; please report this with the folder {}", message,
                           folder.string()));
}

ExitStatus RunGuarded(const Action& action, Session& session) {
  try {
    return action(session);
  } catch (const CallError& error) {
    session.Fail(error.what());
    return ExitStatus::kWrongCall;
  } catch (const robot::DescriptionError& error) {
    session.Fail(error.what());
    return ExitStatus::kWrongCall;
  } catch (const InternalError& error) {
    ReportMistake(error.what(), error.evidence(), session);
  } catch (const std::exception& error) {
    ReportMistake(error.what(), CrashFolder(), session);
  }
  return ExitStatus::kInternalError;
}

}  // namespace

ExitStatus RunCommandLine(int argc, char** argv) {
  CLI::App app(kDescription, "taskc");
  app.footer(kFooter);
  app.set_version_flag("--version", kVersion);
  app.require_subcommand(1);

  Session session;
  std::vector<Action> actions;
  for (const Verb& verb : kVerbs) actions.push_back(Declare(verb, app, session));
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wish) {  // --help, --version
    app.exit(wish);
    return ExitStatus::kOk;
  } catch (const CLI::ParseError& error) {
    PrintError(fmt::format("{} (see `taskc --help`)", command_line::WhatIsWrong(app, error)));
    return ExitStatus::kWrongCall;
  }

  ExitStatus status = ExitStatus::kOk;
  for (size_t i = 0; i < kVerbs.size(); ++i) {
    if (app.got_subcommand(kVerbs[i].name)) status = RunGuarded(actions[i], session);
  }
  session.Finish(status);
  return status;
}

}  // namespace compiler
