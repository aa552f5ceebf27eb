// trainer rescore DIR --task NEW.task
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "base/text/print.h"
#include "runtime/base/user_error.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/rescore/rescore_report.h"
#include "runtime/trainer/rescore/rescore_runs.h"
#include "runtime/trainer/runs/many_runs.h"
#include "runtime/trainer/setup/sandbox_rules.h"
#include "runtime/trainer/setup/task_setup.h"

namespace runtime {
namespace {

struct RescoreOptions {
  std::filesystem::path folder;
  TaskOptions task;
  int64_t episode = 0;  // 0: all that are recorded
  bool json = false;
};

// Where there are many, one that cannot be rescored is left out with a line.
std::vector<RescoredRun> RescoreAll(const RescoreOptions& options,
                                    const std::shared_ptr<const Plugin>& new_task,
                                    const StopRequest& stop) {
  const std::vector<std::filesystem::path> folders = FindRuns(options.folder);
  if (folders.empty()) {
    return {RescoreRun(options.folder, options.folder.string(), new_task, options.episode, stop)};
  }
  std::vector<RescoredRun> runs;
  for (const std::filesystem::path& folder : folders) {
    if (stop.signal() != 0) break;
    const std::string name = folder.lexically_relative(options.folder).string();
    try {
      runs.push_back(RescoreRun(folder, name, new_task, options.episode, stop));
    } catch (const UserError& error) {
      text::Print(stderr, "{}: left out: {}\n", name, error.what());
    }
  }
  if (runs.empty() && stop.signal() == 0)
    throw UserError(fmt::format("{}: no run here can be rescored", options.folder.string()));
  return runs;
}

int Rescore(const RescoreOptions& options) {
  const BuiltTask built(options.task);
  if (!built.plugin()) return kFailed;
  // Who reads a run's database writes beside it.
  SandboxRules rules{.files = {.readable = {options.task.task}, .writable = {options.folder}}};
  built.AddTo(rules.files);
  const CommandSandbox sandbox(rules);
  const auto new_task = std::make_shared<const Plugin>(*built.plugin(), options.task.task);
  const StopRequest stop;
  const std::vector<RescoredRun> runs = RescoreAll(options, new_task, stop);
  if (stop.signal() != 0) return kStoppedBySignal + stop.signal();
  const std::string name = options.task.task.string();
  if (options.json) {
    text::Print(
        "{}\n",
        RescoreJson(name, runs).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    text::Print("{}", RescoreText(name, runs));
  }
  return kSuccess;
}

}  // namespace

void AddRescoreCommand(command_line::Command& program) {
  const auto options = std::make_shared<RescoreOptions>();
  command_line::Command& command = program.AddCommand(
      "rescore",
      "Judges the recorded episodes of a run, or of all runs in a folder, by another task: what "
      "it would have paid, how it would have ended them, and in which order it puts the runs.");
  command.AddOption("DIR", options->folder, "folder of the run, or of many runs").Required();
  command
      .AddOption("--task", options->task.task, "a .task file, or a .so that taskc built from one")
      .Required()
      .ValueName("FILE.task");
  AddRobotsOption(command, options->task.robots);
  command
      .AddOption("--episode", options->episode,
                 "judge only this episode; by default all that are recorded")
      .Range(1, 1'000'000'000);
  command.AddFlag("--json", options->json, "print JSON");
  AddSandboxOption(command);
  command.OnRun([options] { return Rescore(*options); });
}

}  // namespace runtime
