#include <fmt/format.h>

#include <memory>

#include "runtime/trainer/commands.h"
#include "runtime/trainer/runs/guard.h"
#include "runtime/trainer/runs/many_runs.h"
#include "runtime/trainer/runs/one_run.h"
#include "runtime/trainer/setup/apart.h"
#include "runtime/trainer/setup/create_run.h"
#include "runtime/trainer/setup/made_folder.h"
#include "runtime/trainer/setup/sandbox_rules.h"
#include "runtime/trainer/setup/start_check.h"
#include "runtime/trainer/setup/task_setup.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/run_settings.h"

namespace runtime {
namespace {

struct TrainOptions {
  TaskOptions task;
  RunPlan plan;
  int64_t runs = 1;
  std::filesystem::path out;
  SessionOptions session;
};

int TrainOne(const TrainOptions& options) {
  const MadeFolder folder(options.out.empty() ? kRunsFolder : options.out);
  return RunGuarded(
      [&] { return TrainOneRun(options.task, options.plan, options.out, options.session); },
      [&](const std::filesystem::path& run, Pace pace) {
        return ResumeOneRun(run, std::nullopt, options.session.At(pace));
      });
}

// Returns the folder of their folders.
Words MakeRuns(const TrainOptions& options, const std::filesystem::path& plugin) {
  const std::filesystem::path outer = options.out.empty() ? kRunsFolder : options.out;
  TaskSetup setup = SetUpInSandbox(options.task, plugin, options.plan.seed, outer);
  const RunRecord run = RecordOf(setup, options.plan);
  const std::filesystem::path folder = options.out.empty() ? outer / NameOfRuns(run) : outer;
  setup.graph.Start();
  const uint64_t end = run.seed + static_cast<uint64_t>(options.runs);
  for (uint64_t seed = run.seed; seed < end; ++seed) {
    RunDatabase::CheckIsFree(SeedFolder(folder, seed));
  }
  WarnOfStart(setup);
  for (uint64_t seed = run.seed; seed < end; ++seed) {
    PrepareRun(SeedFolder(folder, seed), setup, run, seed);
  }
  return {folder.string()};
}

// Makes all runs before the first one starts, so that they go on with the same task and agent
// whatever becomes of the files; each is then trained as if it were resumed.
int TrainMany(const TrainOptions& options) {
  const BuiltTask task(options.task);
  if (!task.plugin()) return kFailed;
  WarnWhereSandboxIsWeak();
  const MadeFolder outer(options.out.empty() ? kRunsFolder : options.out);
  const std::filesystem::path folder = RunApart(options.task.task.string(), [&] {
                                         return MakeRuns(options, *task.plugin());
                                       }).front();
  return TrainRuns(folder, FindRuns(folder), options.session.jobs, options.session.output);
}
int Train(const TrainOptions& options) {
  return options.runs == 1 ? TrainOne(options) : TrainMany(options);
}

}  // namespace

void AddTrainCommand(command_line::Command& program) {
  const auto options = std::make_shared<TrainOptions>();
  command_line::Command& command =
      program.AddCommand("train", "Starts one run or many: trains a robot on a task.");
  options->task.AddTo(command);
  options->plan.AddTo(command);
  command.AddOption("--runs", options->runs, "how many runs to train, each with its own seed")
      .Range(1, 10'000)
      .ShowDefault();
  AddJobsOption(command, options->session.jobs,
                "how many runs to train, or episodes of one run to run, at a time");
  command
      .AddOption("--out", options->out,
                 "folder of the run, by default runs/TASK-PROFILE-seedSEED; of many runs, the "
                 "folder of their folders, by default runs/TASK-PROFILE")
      .ValueName("DIR");
  options->session.AddTo(command);
  command.OnRun([options] { return Train(*options); });
}

}  // namespace runtime
