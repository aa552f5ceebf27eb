#include "runtime/trainer/runs/one_run.h"

#include <fmt/format.h>

#include "base/text/print.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/runs/kept_run.h"
#include "runtime/trainer/runs/worker_sandbox.h"
#include "runtime/trainer/setup/sandbox_rules.h"
#include "runtime/trainer/setup/start_check.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/run_settings.h"

namespace runtime {
namespace {

// Whether a session with nothing left to train would end at once.
bool HasNothingToDo(bool has_episodes_left, const SessionOptions& session) {
  return !has_episodes_left && session.when_done == LiveRun::WhenDone::kEnd;
}

void WarnOfOtherVersion(const RunRecord& run) {
  if (run.version == TASKC_VERSION) return;
  text::Print(
      stderr,
      "warning: the run was started by trainer {}, this is {}: it may continue differently\n",
      run.version, TASKC_VERSION);
}

}  // namespace

int TrainOneRun(const TaskOptions& options, const RunPlan& plan,
                const std::filesystem::path& named_folder, const SessionOptions& session,
                const ModuleTypes& types) {
  const BuiltTask task(options);
  if (!task.plugin()) return kFailed;
  WorkerSandbox sandbox(session);
  const std::filesystem::path outer = named_folder.empty() ? kRunsFolder : named_folder;
  TaskSetup setup(options, *task.plugin(), plan.seed, types,
                  [&](const TaskSetup& known) { sandbox.Enter(RulesOf(known, outer)); });
  RunRecord run = RecordOf(setup, plan);
  const std::filesystem::path folder =
      named_folder.empty()
          ? std::filesystem::path(kRunsFolder) / fmt::format("{}-seed{}", NameOfRuns(run), run.seed)
          : named_folder;
  RunDatabase::CheckIsFree(folder);
  setup.graph.Start();  // the last that can be wrong: only now the folder is made
  WarnOfStart(setup);
  RunDatabase database = CreateRun(folder, setup, run);
  if (named_folder.empty()) sandbox.NarrowTo(folder);
  return RunSession({folder, run, database, setup.graph, setup.types, setup.context}, session,
                    sandbox.TakeLoopback());
}

bool PlanEpisodes(std::optional<int64_t> episodes, RunDatabase& database, RunRecord& run) {
  const int64_t done = database.ReadCheckpointEpisode();
  if (episodes) {
    if (*episodes < done) {
      throw command_line::CallError(fmt::format(
          "--episodes {}: the run has {} episodes already; name a larger number", *episodes, done));
    }
    run.episodes_planned = *episodes;
    database.SetEpisodesPlanned(run.episodes_planned);
  }
  return done < run.episodes_planned;
}

int ResumeOneRun(const std::filesystem::path& folder, std::optional<int64_t> episodes,
                 const SessionOptions& session, const ModuleTypes& types) {
  RunDatabase database = RunDatabase::Open(folder);
  RunRecord run = database.ReadRun();
  const RunState run_state = database.ReadState();
  if (HasNothingToDo(PlanEpisodes(episodes, database, run), session)) {
    // A run that was finished long ago keeps the time at which it was.
    if (run_state != RunState::kFinished) database.SetState(RunState::kFinished);
    if (IsForPeople(session.output.style())) {
      text::Print("all {} episodes of this run are done; train more with a larger `--episodes`\n",
                  run.episodes_planned);
    }
    return kSuccess;
  }
  WarnOfOtherVersion(run);
  WorkerSandbox sandbox(session);
  sandbox.Enter(RulesOf(AgentOfRun(folder, run), folder));
  KeptRun kept(folder, run, folder, types);
  kept.graph.Start();
  database.SetState(RunState::kRunning);
  return RunSession({folder, run, database, kept.graph, kept.types, kept.context}, session,
                    sandbox.TakeLoopback());
}

}  // namespace runtime
