#include "runtime/trainer/reproduce/reproduce_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/command_line/command.h"
#include "runtime/base/scratch_folder.h"
#include "runtime/base/user_error.h"
#include "runtime/live/control/live_run.h"
#include "runtime/trainer/runs/kept_run.h"
#include "runtime/trainer/runs/many_runs.h"
#include "runtime/trainer/setup/sandbox_rules.h"
#include "runtime/training/run/compression.h"
#include "runtime/training/run/machine_record.h"
#include "runtime/training/run/module_types.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/run_files.h"
#include "runtime/training/run/stop_request.h"
#include "runtime/training/run/training.h"

namespace runtime {
namespace {

// Repeats a run, and ends it with the first episode that is another one than was recorded.
class ComparedRun : public LiveRun {
 public:
  ComparedRun(const RunParts& run, Progress& progress, const StopRequest& stop,
              const std::vector<EpisodeRecord>& recorded)
      : LiveRun(run, progress, WhenDone::kEnd, stop), run_(run.record), recorded_(recorded) {}

  void AfterEpisode(const EpisodeRecord& episode, const ReturnStatistics& statistics,
                    bool checkpoint_was_saved) override {
    LiveRun::AfterEpisode(episode, statistics, checkpoint_was_saved);
    if (!differences_.empty()) return;
    differences_ = DifferencesOf(recorded_[static_cast<size_t>(episode.number - 1)], episode, run_);
    if (differences_.empty()) equal_ = episode.number;
  }
  bool wants_stop() const override { return !differences_.empty() || LiveRun::wants_stop(); }

  int64_t equal() const { return equal_; }
  const std::vector<ValueDifference>& differences() const { return differences_; }

 private:
  const RunRecord& run_;
  const std::vector<EpisodeRecord>& recorded_;
  std::vector<ValueDifference> differences_;
  int64_t equal_ = 0;
};

// What stands in the record.
struct Recorded {
  RunRecord run;
  std::vector<EpisodeRecord> episodes;
  std::vector<ChangeRecord> changes;
  std::vector<MachineRecord> machines;
  std::optional<Checkpoint> checkpoint;  // of the last of these episodes
};

Recorded ReadRecord(const ReproduceOptions& options) {
  const RunDatabase database = RunDatabase::OpenToRead(options.folder);
  auto [run, episodes] = database.ReadRunAndEpisodes();
  Recorded recorded{std::move(run), std::move(episodes), database.ReadChanges(),
                    ReadMachines(options.folder), std::nullopt};
  const auto count = static_cast<int64_t>(recorded.episodes.size());
  if (count == 0) {
    throw UserError(
        fmt::format("{}: no episode of this run is recorded yet: there is nothing to "
                    "compare with",
                    options.folder.string()));
  }
  if (options.episodes.value_or(count) > count) {
    throw command_line::CallError(
        fmt::format("--episodes {}: the run has {} episodes", *options.episodes, count));
  }
  recorded.episodes.resize(static_cast<size_t>(options.episodes.value_or(count)));
  const auto last = static_cast<int64_t>(recorded.episodes.size());
  if (database.ReadCheckpointEpisode() == last) recorded.checkpoint = database.ReadCheckpoint();
  return recorded;
}

void TrainAgain(const RunParts& run, const ReproduceOptions& options,
                const std::vector<EpisodeRecord>& recorded, Reproduction& found) {
  const StopRequest stop;
  Progress progress(options.style, run.record, stdout, stderr);
  ComparedRun compared(run, progress, stop, recorded);
  Training training(run.graph, run.record, run.database, progress, compared);
  training.Restore();
  const int jobs = EpisodesAtATime(options.jobs);
  if (jobs > 1) training.RunSideBySide(jobs, run.types, run.context);
  training.Run(stop);
  found.equal = compared.equal();
  found.differences = compared.differences();
  if (found.equal < found.episodes && found.differences.empty()) found.stop_signal = stop.signal();
}

// With the machine that `episode` was trained on.
std::vector<CauseComparison> CompareCauses(const Recorded& recorded, const RebuiltRun& rebuilt,
                                           int64_t episode) {
  const MachineFacts there = FactsAt(recorded.machines, episode);
  std::vector<CauseComparison> causes;
  for (const CompilerOfTask& each : rebuilt.compilers) {
    causes.push_back(
        {fmt::format("compiler of task {}", VersionText(TaskWithId(recorded.run, each.task))),
         each.recorded, each.here});
  }
  for (const MachineFact& fact : ThisMachine()) {
    const auto old = std::ranges::find(there, fact.name, &MachineFact::name);
    causes.push_back({fact.name, old == there.end() ? "" : old->value, fact.value});
  }
  // All that an older version has written down.
  if (there.empty() && recorded.run.version != TASKC_VERSION) {
    const auto trainer = std::ranges::find(causes, "trainer", &CauseComparison::name);
    trainer->recorded = recorded.run.version;
  }
  return causes;
}

// Changes that had an effect up to `episode`, and then were taken back.
std::string TakenBackText(const std::vector<ChangeRecord>& changes, int64_t episode) {
  std::string text;
  for (const ChangeRecord& change : TakenBack(changes)) {
    if (change.episode > episode) continue;
    text +=
        fmt::format("{}`{}` in episode {}", text.empty() ? "" : ", ", change.text, change.episode);
  }
  return text;
}

bool AreEqual(const Checkpoint& a, const Checkpoint& b) {
  constexpr const char* kWhat = "the checkpoint";
  return a.state == b.state || Decompress(a.state, kWhat) == Decompress(b.state, kWhat);
}

}  // namespace

Reproduction ReproduceRun(const ReproduceOptions& options) {
  const Recorded recorded = ReadRecord(options);
  RunRecord plan = recorded.run;
  plan.episodes_planned = static_cast<int64_t>(recorded.episodes.size());
  plan.record_every = 0;
  plan.checkpoint_seconds = 1e9;  // [s] never but at the end
  const ScratchFolder scratch;
  const std::filesystem::path folder = scratch.path() / "run";
  MakeRunFolder(folder);
  RebuiltRun rebuilt = Rebuild(options.folder, plan, recorded.changes, options.plugins, folder);
  Reproduction found{.name = options.folder.lexically_normal().string(),
                     .episodes = plan.episodes_planned,
                     .changes = std::ranges::count_if(recorded.changes, [&](const auto& change) {
                       return change.episode <= plan.episodes_planned;
                     })};
  const CommandSandbox sandbox(RulesOf(ParseAgent(rebuilt.run.agent, "agent"), scratch.path()));
  RunDatabase database = RunDatabase::Open(folder);
  KeptRun kept(folder, rebuilt.run, folder, ProgramModuleTypes());
  kept.graph.Start();
  TrainAgain({folder, rebuilt.run, database, kept.graph, kept.types, kept.context}, options,
             recorded.episodes, found);
  const bool is_done = found.equal == found.episodes;
  if (is_done && recorded.checkpoint) {
    found.is_state_equal = AreEqual(*recorded.checkpoint, *database.ReadCheckpoint());
  }
  const int64_t last = std::min(found.equal + 1, found.episodes);
  found.causes = CompareCauses(recorded, rebuilt, last);
  if (!found.is_equal()) found.taken_back = TakenBackText(recorded.changes, last);
  return found;
}

}  // namespace runtime
