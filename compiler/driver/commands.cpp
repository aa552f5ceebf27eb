#include "compiler/driver/commands.h"

#include <fmt/format.h>

#include <cstdio>

#include "compiler/build/build_plugin.h"
#include "compiler/build/file_io.h"
#include "compiler/build/internal_error.h"
#include "compiler/build/plugin_cache.h"
#include "compiler/driver/front_end.h"
#include "compiler/driver/print_error.h"
#include "compiler/emit/emit.h"

namespace compiler {
namespace {

ExitStatus Execute(const BuildCommand& command, FrontEnd& front_end) {
  FrontEnd::Result checked = front_end.Check(command.task);
  if (!checked.task) return ExitStatus::kWrongTask;
  std::filesystem::path cache = command.cache.empty() ? DefaultCacheFolder() : command.cache;
  try {
    BuildResult built = BuildPlugin(checked.task->name, Emit(*checked.task, checked.source), cache);
    if (command.output.empty()) {
      fmt::print("{}\n", built.plugin.string());
    } else {
      CopyWholeFile(built.plugin, command.output);
    }
  } catch (const InternalError& error) {
    WriteWholeFile(error.evidence() / (checked.task->name + ".task"), checked.source.text());
    throw;
  }
  return ExitStatus::kOk;
}

std::string Describe(const CheckedTask& task) {
  auto count = [](size_t number, std::string_view what) {
    return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
  };
  return fmt::format("{}, {}, {}", count(task.sensors.size(), "sensor"),
                     count(task.terms.size(), "term"), count(task.ends.size(), "end"));
}

ExitStatus CheckOne(const std::string& file, FrontEnd& front_end) {
  FrontEnd::Result checked = front_end.Check(file);
  if (!checked.task) return ExitStatus::kWrongTask;
  fmt::print("{}: ok ({})\n", file, Describe(*checked.task));
  return ExitStatus::kOk;
}

// A file that cannot be read does not keep the others from being checked.
ExitStatus Execute(const CheckCommand& command, FrontEnd& front_end) {
  ExitStatus status = ExitStatus::kOk;
  for (const std::string& file : command.tasks) {
    try {
      status = Worse(status, CheckOne(file, front_end));
    } catch (const CallError& error) {
      PrintError(error.what());
      status = Worse(status, ExitStatus::kWrongCall);
    }
  }
  return status;
}

ExitStatus Execute(const EmitCommand& command, FrontEnd& front_end) {
  FrontEnd::Result checked = front_end.Check(command.task);
  if (!checked.task) return ExitStatus::kWrongTask;
  std::string cpp = Emit(*checked.task, checked.source);
  if (command.output.empty()) {
    fmt::print("{}", cpp);
  } else {
    ReplaceFile(command.output, cpp);
  }
  return ExitStatus::kOk;
}

}  // namespace

ExitStatus Execute(const CommandLine& line) {
  FrontEnd front_end(line.robots);
  ExitStatus status =
      std::visit([&](const auto& command) { return Execute(command, front_end); }, line.command);
  if (std::string summary = front_end.Summary(); !summary.empty()) {
    fmt::print(stderr, "{}\n", summary);
  }
  return status;
}

}  // namespace compiler
