#include <memory>
#include <optional>

#include "runtime/trainer/commands.h"
#include "runtime/trainer/runs/guard.h"
#include "runtime/trainer/runs/many_runs.h"
#include "runtime/trainer/runs/one_run.h"
#include "runtime/trainer/serve/serve_runs.h"
#include "runtime/trainer/setup/made_folder.h"
#include "runtime/training/run/run_database.h"

namespace runtime {
namespace {

struct ServeOptions {
  TaskOptions task;  // or a folder in the place of the task: of a run, or of many
  RunPlan plan;
  std::filesystem::path out;
  SessionOptions session;
};

int Serve(const ServeOptions& options) {
  const std::filesystem::path& served = options.task.task;
  const bool is_run = RunDatabase::Exists(served);
  if (!is_run && std::filesystem::is_directory(served)) {
    return ServeRuns(served, options.task.robots, options.session);
  }
  const auto resume = [&](const std::filesystem::path& run, Pace pace) {
    return ResumeOneRun(run, std::nullopt, options.session.At(pace));
  };
  std::optional<MadeFolder> folder;
  if (!is_run) folder.emplace(options.out.empty() ? kRunsFolder : options.out);
  return RunGuarded(
      [&] {
        return is_run ? resume(served, Pace::kAsAsked)
                      : TrainOneRun(options.task, options.plan, options.out, options.session);
      },
      resume);
}

}  // namespace

void AddServeCommand(command_line::Command& program) {
  const auto options = std::make_shared<ServeOptions>();
  options->session.when_done = LiveRun::WhenDone::kWait;
  command_line::Command& command = program.AddCommand(
      "serve",
      "Trains like `train`, or like `resume` if given a run's folder, then waits for requests. "
      "Given "
      "a folder of many runs, serves a page on which they are watched, started and stopped.");
  options->task.AddTo(command);
  options->plan.AddTo(command);
  command
      .AddOption("--out", options->out,
                 "folder of a new run; by default runs/TASK-PROFILE-seedSEED")
      .ValueName("DIR");
  AddJobsOption(command, options->session.jobs,
                "how many episodes, or runs of a folder, to run at a time");
  options->session.AddTo(command);
  command.Notes("`trainer ctl` talks to it.");
  command.OnRun([options] { return Serve(*options); });
}

}  // namespace runtime
