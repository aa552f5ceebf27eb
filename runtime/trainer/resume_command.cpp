#include <fmt/format.h>

#include <optional>

#include "runtime/agent/agent.h"
#include "runtime/run/module_types.h"
#include "runtime/run/run_database.h"
#include "runtime/run/run_files.h"
#include "runtime/task/plugin.h"
#include "runtime/trainer/call_error.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/many_runs.h"
#include "runtime/trainer/run_session.h"

namespace runtime {
namespace {

struct ResumeOptions {
  std::filesystem::path folder;
  std::optional<int64_t> episodes;
  int jobs = 0;
  OutputOptions output;
};

// Sets how many episodes the run is to have. Returns whether there is something left to do.
bool PlanEpisodes(const ResumeOptions& options, RunDatabase& database, RunRecord& run) {
  const std::optional<Checkpoint> checkpoint = database.ReadCheckpoint();
  const int64_t done = checkpoint ? checkpoint->episode : 0;
  if (options.episodes) {
    if (*options.episodes < done) {
      throw CallError(
          fmt::format("--episodes {}: the run has {} episodes already; name a larger number",
                      *options.episodes, done));
    }
    run.episodes_planned = *options.episodes;
    database.SetEpisodesPlanned(run.episodes_planned);
  }
  return done < run.episodes_planned;
}

int ResumeOne(const ResumeOptions& options) {
  RunDatabase database = RunDatabase::Open(options.folder);
  RunRecord run = database.ReadRun();
  const RunState run_state = database.ReadState();
  const ProgressStyle style = options.output.style();
  if (!PlanEpisodes(options, database, run)) {
    // A run that was finished long ago keeps the time at which it was.
    if (run_state != RunState::kFinished) database.SetState(RunState::kFinished);
    if (style == ProgressStyle::kText) {
      fmt::print("all {} episodes of this run are done; a larger `--episodes` trains on\n",
                 run.episodes_planned);
    }
    return kSuccess;
  }
  if (run.version != TASKC_VERSION) {
    fmt::print(stderr,
               "warning: the run was started by trainer {}, this is {}: it may go on differently\n",
               run.version, TASKC_VERSION);
  }
  const auto plugin =
      std::make_shared<const Plugin>(FindKeptPlugin(options.folder, run.tasks.front().plugin));
  const robot::RobotDescription robot = ReadKeptRobot(options.folder, run.robot_description);
  ModuleTypes types;
  RegisterModuleTypes(types);
  const Agent agent = ParseAgent(run.agent, (options.folder / "run.db").string() + ": agent");
  Network network = BuildNetwork(agent, types, Context{&robot, plugin, run.seed});
  network.Start();
  database.SetState(RunState::kRunning);
  return RunSession(options.folder, network, run, database, style);
}

// In a folder of runs the new number of episodes is set first, for all of them.
int ResumeMany(const ResumeOptions& options, const std::vector<std::filesystem::path>& runs) {
  if (options.episodes) {
    for (const std::filesystem::path& folder : runs) {
      RunDatabase database = RunDatabase::Open(folder);
      RunRecord run = database.ReadRun();
      PlanEpisodes(options, database, run);
    }
  }
  return TrainRuns(options.folder, options.jobs, options.output);
}

int Resume(const ResumeOptions& options) {
  const std::vector<std::filesystem::path> runs = FindRuns(options.folder);
  const bool is_one = runs.empty() || RunDatabase::Exists(options.folder);
  return is_one ? ResumeOne(options) : ResumeMany(options, runs);
}

}  // namespace

void AddResumeCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<ResumeOptions>();
  CLI::App* command =
      app.add_subcommand("resume", "Goes on with a run, or all runs of a folder, bit for bit.");
  command->add_option("DIR", options->folder, "folder of the run, or of many")->required();
  command
      ->add_option("--episodes", options->episodes,
                   "how many episodes the run is to have in all; otherwise as planned")
      ->check(CLI::Range(int64_t{1}, int64_t{1'000'000'000}));
  AddJobsOption(*command, options->jobs);
  options->output.AddTo(*command);
  command->callback([options, &status] { status = Resume(*options); });
}

}  // namespace runtime
