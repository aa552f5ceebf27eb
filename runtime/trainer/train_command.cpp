#include <fmt/format.h>

#include "runtime/run/run_database.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/create_run.h"
#include "runtime/trainer/many_runs.h"
#include "runtime/trainer/run_session.h"
#include "runtime/trainer/task_setup.h"

namespace runtime {
namespace {

struct TrainOptions {
  TaskOptions task;
  RunPlan plan;
  int64_t runs = 1;
  int jobs = 0;  // 0: one for each core
  std::filesystem::path out;
  OutputOptions output;
};

// `name`: of the folder, where the user names none.
std::filesystem::path FolderOf(const TrainOptions& options, const std::string& name) {
  return options.out.empty() ? std::filesystem::path("runs") / name : options.out;
}

int TrainOne(const TrainOptions& options, const std::filesystem::path& plugin) {
  TaskSetup setup(options.task, plugin, options.plan.seed);
  RunRecord run = RecordOf(setup, options.plan);
  const std::filesystem::path folder =
      FolderOf(options, fmt::format("{}-{}-seed{}", run.tasks.front().task, run.profile, run.seed));
  RunDatabase::CheckIsFree(folder);
  setup.network.Start();  // the last that can be wrong: only now the folder is made
  RunDatabase database = CreateRun(folder, setup, run);
  return RunSession(folder, setup.network, run, database, options.output.style());
}

// Makes all runs before the first one starts, so that they go on with the same task and agent
// whatever becomes of the files; each is then trained as if it were resumed.
int TrainMany(const TrainOptions& options, const std::filesystem::path& plugin) {
  TaskSetup setup(options.task, plugin, options.plan.seed);
  const RunRecord run = RecordOf(setup, options.plan);
  const std::filesystem::path folder =
      FolderOf(options, fmt::format("{}-{}", run.tasks.front().task, run.profile));
  setup.network.Start();
  const uint64_t end = run.seed + static_cast<uint64_t>(options.runs);
  for (uint64_t seed = run.seed; seed < end; ++seed) {
    RunDatabase::CheckIsFree(SeedFolder(folder, seed));
  }
  for (uint64_t seed = run.seed; seed < end; ++seed) {
    PrepareRun(SeedFolder(folder, seed), setup, run, seed);
  }
  return TrainRuns(folder, options.jobs, options.output);
}

int Train(const TrainOptions& options) {
  const BuiltTask task(options.task.task);
  if (!task.plugin()) return kFailed;
  return options.runs == 1 ? TrainOne(options, *task.plugin()) : TrainMany(options, *task.plugin());
}

}  // namespace

void AddTrainCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<TrainOptions>();
  CLI::App* command =
      app.add_subcommand("train", "Starts a run, or many: trains a robot in a task.");
  options->task.AddTo(*command);
  command->add_option("--episodes", options->plan.episodes, "how many episodes to train")
      ->check(CLI::Range(int64_t{1}, int64_t{1'000'000'000}))
      ->capture_default_str();
  command
      ->add_option("--seed", options->plan.seed,
                   "seed of all chance, of many runs the first one's; equal seeds give equal runs")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      ->add_option("--runs", options->runs, "how many runs to train, each with a seed of its own")
      ->check(CLI::Range(int64_t{1}, int64_t{10'000}))
      ->capture_default_str();
  AddJobsOption(*command, options->jobs);
  command->add_option("--out", options->out,
                      "folder of the run; otherwise runs/TASK-PROFILE-seedSEED. Of many runs the "
                      "folder of their folders; otherwise runs/TASK-PROFILE");
  command
      ->add_option("--record-every", options->plan.record_every,
                   "record every N-th episode besides the best ones and the last; 0: only these")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      ->add_option("--checkpoint-every", options->plan.checkpoint_seconds,
                   "seconds between two checkpoints, at least")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  options->output.AddTo(*command);
  command->callback([options, &status] { status = Train(*options); });
}

}  // namespace runtime
