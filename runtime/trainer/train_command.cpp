#include <fmt/format.h>

#include <algorithm>

#include "plugins/robot/robot_description.h"
#include "runtime/module/suggestion.h"
#include "runtime/run/body_json.h"
#include "runtime/run/module_types.h"
#include "runtime/run/run_database.h"
#include "runtime/run/run_files.h"
#include "runtime/run/task_record.h"
#include "runtime/simulation/profile.h"
#include "runtime/task/plugin.h"
#include "runtime/trainer/agent_layers.h"
#include "runtime/trainer/build_task.h"
#include "runtime/trainer/call_error.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/run_session.h"
#include "runtime/trainer/scratch_folder.h"

namespace runtime {
namespace {

struct TrainOptions {
  std::filesystem::path task;
  int64_t episodes = 1000;
  uint64_t seed = 0;
  std::string profile;
  std::filesystem::path out;
  std::filesystem::path agent;
  std::string robot;
  int64_t record_every = 50;
  double checkpoint_seconds = 60;
  std::vector<std::string> settings;
  OutputOptions output;
};

void CheckTaskFile(const std::filesystem::path& task) {
  if (task.extension() != ".task" && task.extension() != ".so") {
    throw CallError(fmt::format(
        "{}: a task is a .task file, or a .so file that taskc has built from one", task.string()));
  }
  if (std::filesystem::exists(task)) return;
  std::vector<std::string> neighbours;
  const std::filesystem::path folder = task.has_parent_path() ? task.parent_path() : ".";
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() == task.extension()) {
      neighbours.push_back(entry.path().filename().string());
    }
  }
  std::sort(neighbours.begin(), neighbours.end());
  throw CallError(
      fmt::format("{}: there is no such file{}", task.string(),
                  neighbours.empty() ? "" : Suggestion(task.filename().string(), neighbours)));
}

// Runs without an end would never reach their second episode.
void CheckHasEnd(const taskc_plugin& plugin) {
  if (plugin.end_count > 0) return;
  throw UserError(
      fmt::format("{}: no episode of task `{}` ever ends; add a limit, for example "
                  "`if time > 20 s {{ truncate_episode \"time is up\" }}` in `on end_of_time_step`",
                  plugin.sources[0].file, plugin.name));
}

std::string RobotName(const TrainOptions& options, const taskc_plugin& plugin) {
  const std::string name = options.robot.empty() ? plugin.robot : options.robot;
  if (name.empty()) {
    throw CallError(fmt::format(
        "task `{}` is for no robot in particular; name one, for example `--robot humanoid`",
        plugin.name));
  }
  return name;
}

AgentLayers LayersOf(const TrainOptions& options, const taskc_plugin& plugin,
                     const std::filesystem::path& robot_file) {
  AgentLayers layers{robot_file, plugin.start_pose, options.task, options.agent, options.settings};
  if (!options.profile.empty()) {
    layers.settings.insert(layers.settings.begin(), "environment.profile=" + options.profile);
  }
  return layers;
}

int TrainPlugin(const TrainOptions& options, const std::filesystem::path& plugin_file) {
  RunRecord run;
  const Plugin plugin(plugin_file);
  CheckHasEnd(plugin.table());
  DescribeTask(plugin.table(), run);
  const std::filesystem::path robot_file =
      robot::FindRobotFile(RobotName(options, plugin.table()), robot::DefaultRobotFolders());
  const robot::RobotDescription robot = robot::ReadRobot(robot_file);

  ModuleTypes types;
  RegisterModuleTypes(types);
  const Agent agent = LayersOf(options, plugin.table(), robot_file).Merge();
  Network network = BuildNetwork(agent, types, Context{&robot, plugin_file, options.seed});

  run.robot = robot.name;
  run.robot_description = ReadText(robot_file);
  run.body = BodyJson(robot);
  run.agent = ToToml(Resolved(agent, network));
  run.profile = std::get<std::string>(network.Find("environment").Get("profile"));
  run.version = TASKC_VERSION;
  run.seed = options.seed;
  run.episodes_planned = options.episodes;
  run.record_every = options.record_every;
  run.checkpoint_seconds = options.checkpoint_seconds;
  std::filesystem::path folder = options.out;
  if (folder.empty()) {
    folder = std::filesystem::path("runs") /
             fmt::format("{}-{}-seed{}", run.task, run.profile, run.seed);
  }
  RunDatabase::CheckIsFree(folder);
  network.Start();  // the last that can be wrong: only now the folder is made

  run.plugin = KeepPlugin(plugin_file, folder);
  RunDatabase database = RunDatabase::Create(folder, run);
  return RunSession(folder, network, run, database, options.output.style());
}

int Train(const TrainOptions& options) {
  CheckTaskFile(options.task);
  if (options.task.extension() == ".so") return TrainPlugin(options, options.task);
  const ScratchFolder scratch;
  const std::filesystem::path plugin = scratch.path() / "task.so";
  if (!BuildTask(options.task, plugin)) return kFailed;  // the compiler has said why
  return TrainPlugin(options, plugin);
}

}  // namespace

void AddTrainCommand(CLI::App& app, int& status) {
  std::vector<std::string> profiles;
  for (const Profile& profile : kProfiles) profiles.emplace_back(profile.name);
  const auto options = std::make_shared<TrainOptions>();
  CLI::App* command = app.add_subcommand("train", "Starts a run: trains a robot in a task.");
  command->add_option("TASK", options->task, "a .task file, or a .so that taskc built from one")
      ->required();
  command->add_option("--episodes", options->episodes, "how many episodes to train")
      ->check(CLI::Range(int64_t{1}, int64_t{1'000'000'000}))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "seed of all chance; equal seeds give equal runs")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      ->add_option("--profile", options->profile,
                   "how to simulate: `paper` faithfully, `fast` with longer steps")
      ->check(CLI::IsMember(profiles));
  command->add_option("--out", options->out,
                      "folder of the run; otherwise runs/TASK-PROFILE-seedSEED");
  command
      ->add_option("--agent", options->agent, "agent file that changes the robot's default agent")
      ->check(CLI::ExistingFile);
  command->add_option("--robot", options->robot,
                      "robot, for a task that is for none in particular");
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
  command
      ->add_option("--set", options->settings,
                   "change a parameter, MODULE.PARAMETER=VALUE; may be repeated")
      ->allow_extra_args(false);
  options->output.AddTo(*command);
  command->callback([options, &status] { status = Train(*options); });
}

}  // namespace runtime
