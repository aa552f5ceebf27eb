#include "runtime/trainer/setup/create_run.h"

#include <fmt/format.h>

#include "runtime/core/task/task_world.h"
#include "runtime/core/task/universal_task.h"
#include "runtime/training/environment/environment.h"
#include "runtime/training/run/body_json.h"
#include "runtime/training/run/run_files.h"
#include "runtime/training/run/run_settings.h"
#include "runtime/training/run/task_modules.h"
#include "runtime/training/run/task_record.h"

namespace runtime {
namespace {

// The record says which plugin an evaluation is of, and an agent has only one.
const std::string& TaskModuleOf(const ModuleGraph& graph) {
  const std::vector<UniversalTask*> tasks = graph.FindAll<UniversalTask>();
  if (tasks.size() <= 1) return graph.FindOnly<UniversalTask>().name();
  throw UserError(
      fmt::format("the agent has two task modules, `{}` and `{}`: keep one, and load others while "
                  "it runs, with `trainer ctl load`",
                  tasks[0]->name(), tasks[1]->name()));
}

// Words of `trainer train` for what no other part of the record says, or says otherwise.
std::vector<std::string> CallOf(const TaskOptions& options, const RunPlan& plan) {
  std::vector<std::string> words = {options.task.lexically_normal().string()};
  const auto add = [&](const char* option, std::string value) {
    words.insert(words.end(), {option, std::move(value)});
  };
  if (!options.robot.empty()) add("--robot", options.robot);
  if (!options.robots.empty()) add("--robots", options.robots.lexically_normal().string());
  if (!options.agent.empty()) {
    add("--agent", std::filesystem::path(options.agent).lexically_normal().string());
  }
  if (!options.environment_socket.empty()) add("--environment-socket", options.environment_socket);
  for (const std::string& setting : options.settings) add("--set", setting);
  if (plan.record_every != RunPlan{}.record_every) {
    add("--record-every", std::to_string(plan.record_every));
  }
  return words;
}

// With its libraries called as they are in the run's folder.
Agent KeptAgent(Agent agent) {
  for (LibrarySetting& library : agent.libraries) library.file = KeptPluginName(library.file);
  return agent;
}

}  // namespace

void RunPlan::AddTo(command_line::Command& command) {
  command.AddOption("--episodes", episodes, "how many episodes to train")
      .Range(1, 1'000'000'000)
      .ShowDefault();
  command
      .AddOption("--seed", seed,
                 "random seed, of many runs that of the first; equal seeds give equal runs")
      .NonNegative()
      .ShowDefault();
  command
      .AddOption("--record-every", record_every,
                 "record every N-th episode besides the best ones and the last; 0: only those")
      .NonNegative()
      .ShowDefault();
  command
      .AddOption("--checkpoint-every", checkpoint_seconds,
                 "least time between two checkpoints, in seconds")
      .NonNegative()
      .ShowDefault();
}

RunRecord RecordOf(const TaskSetup& setup, const RunPlan& plan) {
  RunRecord run;
  run.tasks = {DescribeTask(setup.plugin->table(), TaskModuleOf(setup.graph))};
  run.tasks.front().id = 1;
  FindTaskModules(setup.graph, setup.graph.FindOnly<Learner>());  // throws where none pays it
  run.robot = setup.robot.name;
  if (!setup.robot_file.empty()) run.robot_description = ReadText(setup.robot_file);
  run.body = BodyJson(setup.robot, WorldOf(setup.plugin->table()).get());
  run.agent = ToToml(KeptAgent(setup.agent));
  run.settings = SettingsText(setup.settings);
  run.call = CallText(CallOf(setup.options, plan));
  run.profile = setup.graph.FindOnly<Environment>().profile();
  run.version = TASKC_VERSION;
  run.seed = plan.seed;
  run.episodes_planned = plan.episodes;
  run.record_every = plan.record_every;
  run.checkpoint_seconds = plan.checkpoint_seconds;
  return run;
}

RunDatabase CreateRun(const std::filesystem::path& folder, const TaskSetup& setup, RunRecord& run) {
  RunDatabase::CheckIsFree(folder);
  run.tasks.front().plugin = KeepPlugin(setup.plugin_file, folder);
  for (const LibrarySetting& library : setup.agent.libraries) KeepPlugin(library.file, folder);
  return RunDatabase::Create(folder, run);
}

void PrepareRun(const std::filesystem::path& folder, const TaskSetup& setup, RunRecord run,
                uint64_t seed) {
  run.seed = seed;
  CreateRun(folder, setup, run).SetState(RunState::kInterrupted);
}

}  // namespace runtime
