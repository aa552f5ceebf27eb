#include "runtime/trainer/results/learned_run.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "runtime/live/control/live_run.h"
#include "runtime/training/run/checkpoint.h"

namespace runtime {
namespace {

Checkpoint ReadLastCheckpoint(const std::filesystem::path& folder, const RunDatabase& database,
                              const char* purpose) {
  std::optional<Checkpoint> checkpoint = database.ReadCheckpoint();
  if (checkpoint) return std::move(*checkpoint);
  throw UserError(
      fmt::format("{0}: this run has no checkpoint yet, and so nothing {1}; wait for the first "
                  "one, or continue the run with `trainer resume {0}`",
                  folder.string(), purpose));
}

}  // namespace

// The checkpoint is read first: all that belongs to it is there by then, also while the run is
// being trained.
LearnedRun::LearnedRun(const std::filesystem::path& folder, const RunDatabase& database,
                       const char* purpose)
    : checkpoint(ReadLastCheckpoint(folder, database, purpose)),
      record(database.ReadRun()),
      episodes(database.ReadEpisodes()) {
  std::erase_if(episodes, [&](const auto& each) { return each.number > checkpoint.episode; });
}

Performer::Performer(const std::filesystem::path& folder, LearnedRun& run, RunDatabase& database,
                     const std::string& profile, Progress& progress, const StopRequest& stop,
                     const ModuleTypes& types)
    : kept_(folder, run.record, scratch_.path(), types),
      environment_(kept_.graph.FindOnly<Environment>()),
      learner_(kept_.graph.FindOnly<Learner>()) {
  if (!profile.empty()) environment_.Set("profile", profile);
  kept_.graph.Start();
  // What was changed while the run learned is changed again.
  LiveRun changes({folder, run.record, database, kept_.graph, kept_.types, kept_.context}, progress,
                  LiveRun::WhenDone::kEnd, stop);
  LoadModules(kept_.graph, run.checkpoint.state, changes.BeforeRestore(run.checkpoint.episode));
  tasks_ = FindTaskModules(kept_.graph, learner_);
  learner_.StopLearning();
}

}  // namespace runtime
