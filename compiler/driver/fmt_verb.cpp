// taskc fmt FILE.task...
#include <fmt/format.h>

#include <iostream>
#include <iterator>
#include <memory>

#include "compiler/driver/verb.h"
#include "compiler/format/format.h"
#include "compiler/source/file_reader.h"
#include "compiler/toolchain/file_io.h"

namespace compiler {
namespace {

struct FmtOptions {
  std::vector<std::string> tasks;  // "-": standard input
  bool check = false;
};

ExitStatus FormatFile(const std::string& file, bool check, Session& session) {
  const Sources sources(file, MustReadFromDisk(file));
  Diagnostics diagnostics;
  const auto formatted = Format(sources.main(), diagnostics);
  session.Report(sources, diagnostics);
  if (!formatted) return ExitStatus::kWrongTask;
  const bool is_changed = *formatted != sources.main().text();
  session.Result()["changed"] = is_changed;
  if (!is_changed) return ExitStatus::kOk;
  if (check) {
    session.Say(file + "\n");
    return ExitStatus::kWrongTask;
  }
  RewriteFile(file, *formatted);
  return ExitStatus::kOk;
}

ExitStatus FormatStandardInput(bool check, Session& session) {
  const Sources sources("<stdin>", {std::istreambuf_iterator<char>(std::cin), {}});
  Diagnostics diagnostics;
  const auto formatted = Format(sources.main(), diagnostics);
  session.Report(sources, diagnostics);
  if (!formatted) return ExitStatus::kWrongTask;
  session.Result()["changed"] = *formatted != sources.main().text();
  session.Result()["text"] = *formatted;
  if (!check && session.is_for_a_person()) fmt::print("{}", *formatted);  // a file's content
  return check && *formatted != sources.main().text() ? ExitStatus::kWrongTask : ExitStatus::kOk;
}

}  // namespace

Action DeclareFmt(Command& command, Session& session) {
  auto options = std::make_shared<FmtOptions>();
  AddTasks(command, options->tasks);
  command.AddFlag("--check", options->check,
                  "change nothing, list the files that would change; status 1 if there are any");
  AddReport(command, session);
  return [options](Session& call) {
    return ForEachTask(options->tasks, call, [&](const std::string& file) {
      return file == "-" ? FormatStandardInput(options->check, call)
                         : FormatFile(file, options->check, call);
    });
  };
}

}  // namespace compiler
