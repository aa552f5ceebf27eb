#include <fmt/format.h>

#include "runtime/run/body_json.h"
#include "runtime/run/run_database.h"
#include "runtime/run/run_files.h"
#include "runtime/run/task_record.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/many_runs.h"
#include "runtime/trainer/run_session.h"
#include "runtime/trainer/task_setup.h"

namespace runtime {
namespace {

struct TrainOptions {
  TaskOptions task;
  int64_t episodes = 1000;
  uint64_t seed = 0;
  int64_t runs = 1;
  int jobs = 0;  // 0: one for each core
  std::filesystem::path out;
  int64_t record_every = 50;
  double checkpoint_seconds = 60;
  OutputOptions output;
};

RunRecord RecordOf(const TrainOptions& options, const TaskSetup& setup, uint64_t seed) {
  RunRecord run;
  DescribeTask(setup.plugin.table(), run);
  run.robot = setup.robot.name;
  run.robot_description = ReadText(setup.robot_file);
  run.body = BodyJson(setup.robot);
  run.agent = ToToml(setup.agent);
  run.profile = std::get<std::string>(setup.network.Find("environment").Get("profile"));
  run.version = TASKC_VERSION;
  run.seed = seed;
  run.episodes_planned = options.episodes;
  run.record_every = options.record_every;
  run.checkpoint_seconds = options.checkpoint_seconds;
  return run;
}

int TrainOne(const TrainOptions& options, const std::filesystem::path& plugin) {
  TaskSetup setup(options.task, plugin, options.seed);
  RunRecord run = RecordOf(options, setup, options.seed);
  std::filesystem::path folder = options.out;
  if (folder.empty()) {
    folder = std::filesystem::path("runs") /
             fmt::format("{}-{}-seed{}", run.task, run.profile, run.seed);
  }
  RunDatabase::CheckIsFree(folder);
  setup.network.Start();  // the last that can be wrong: only now the folder is made
  run.plugin = KeepPlugin(plugin, folder);
  RunDatabase database = RunDatabase::Create(folder, run);
  return RunSession(folder, setup.network, run, database, options.output.style());
}

// Makes all runs before the first one starts, so that they go on with the same task and agent
// whatever becomes of the files; each is then trained as if it were resumed.
int TrainMany(const TrainOptions& options, const std::filesystem::path& plugin) {
  TaskSetup setup(options.task, plugin, options.seed);
  RunRecord run = RecordOf(options, setup, options.seed);
  std::filesystem::path folder = options.out;
  if (folder.empty()) {
    folder = std::filesystem::path("runs") / fmt::format("{}-{}", run.task, run.profile);
  }
  setup.network.Start();
  std::vector<std::filesystem::path> folders;
  for (int64_t i = 0; i < options.runs; ++i) {
    folders.push_back(folder / fmt::format("seed{}", options.seed + static_cast<uint64_t>(i)));
    RunDatabase::CheckIsFree(folders.back());
  }
  for (const std::filesystem::path& each : folders) {
    run.plugin = KeepPlugin(plugin, each);
    RunDatabase::Create(each, run).SetState(RunState::kInterrupted);
    ++run.seed;
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
  command->add_option("--episodes", options->episodes, "how many episodes to train")
      ->check(CLI::Range(int64_t{1}, int64_t{1'000'000'000}))
      ->capture_default_str();
  command
      ->add_option("--seed", options->seed,
                   "seed of all chance, of many runs the first one's; equal seeds give equal runs")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--runs", options->runs, "how many runs to train, each with a seed of its own")
      ->check(CLI::Range(int64_t{1}, int64_t{10'000}))
      ->capture_default_str();
  AddJobsOption(*command, options->jobs);
  command->add_option("--out", options->out,
                      "folder of the run; otherwise runs/TASK-PROFILE-seedSEED. Of many runs the "
                      "folder of their folders; otherwise runs/TASK-PROFILE");
  command
      ->add_option("--record-every", options->record_every,
                   "record every N-th episode besides the best ones; 0: only these")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      ->add_option("--checkpoint-every", options->checkpoint_seconds,
                   "seconds between two checkpoints, at least")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  options->output.AddTo(*command);
  command->callback([options, &status] { status = Train(*options); });
}

}  // namespace runtime
