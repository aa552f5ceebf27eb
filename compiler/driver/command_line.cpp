#include "compiler/driver/command_line.h"

#include <fmt/format.h>

#include <cstdio>
#include <system_error>

#include "base/command_line/command.h"
#include "base/command_line/manual.h"
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

constexpr const char* kNotes = "`taskc VERB --help` describes a verb and its options.";

constexpr const char* kEnvironment =
    "CXX, the C++ compiler; TASKC_CACHE, the folder of built plugins;\n"
    "TASKC_ROBOT_PATH, folders with robots; TASKC_LIBRARY_PATH, folders with libraries;\n"
    "NO_COLOR, to turn colors off.";

constexpr const char* kExitStatus =
    "0 success, 1 the task has errors, 2 the command line is wrong, 3 internal error.";

constexpr const char* kVersion = "taskc " TASKC_VERSION;

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
  } catch (const command_line::CallError& error) {
    session.Fail(error.what());
    return ExitStatus::kWrongCall;
  } catch (const robot::DescriptionError& error) {
    session.Fail(error.what());
    return ExitStatus::kWrongCall;
  } catch (const InternalError& error) {
    ReportMistake(error.what(), error.evidence(), session);
  } catch (const std::system_error& error) {
    // What is longer than the stream's buffer fails before main() looks at the stream.
    if (std::ferror(stdout) != 0) {
      session.Fail(fmt::format("cannot write to standard output: {}", error.code().message()));
      return ExitStatus::kWrongCall;
    }
    ReportMistake(error.what(), CrashFolder(), session);
  } catch (const std::exception& error) {
    ReportMistake(error.what(), CrashFolder(), session);
  }
  return ExitStatus::kInternalError;
}

void Declare(const Verb& verb, Command& program, Session& session) {
  Command& command = program.AddCommand(verb.name, verb.title);
  command.Version(kVersion);
  if (*verb.examples != '\0') command.Examples(verb.examples);
  command.OnRun([action = verb.declare(command, session), &session] {
    const ExitStatus status = RunGuarded(action, session);
    session.Finish(status);
    return static_cast<int>(status);
  });
}

}  // namespace

ExitStatus RunCommandLine(int argc, char** argv) {
  Session session;
  Command program("taskc", kDescription);
  program.Notes(kNotes);
  program.Environment(kEnvironment);
  program.ExitStatus(kExitStatus);
  program.Version(kVersion);
  for (const Verb& verb : kVerbs) Declare(verb, program, session);
  command_line::AddManual(program, kVersion, "trainer");
  try {
    const auto run = program.Parse(argc, argv);
    return run ? static_cast<ExitStatus>(run()) : ExitStatus::kOk;
  } catch (const command_line::CallError& error) {
    PrintError(fmt::format("{} (see `taskc --help`)", error.what()));
    return ExitStatus::kWrongCall;
  }
}

}  // namespace compiler
