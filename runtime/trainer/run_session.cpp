#include "runtime/trainer/run_session.h"

#include <fmt/format.h>

#include "runtime/run/stop_request.h"
#include "runtime/run/training.h"
#include "runtime/trainer/commands.h"

namespace runtime {

void OutputOptions::AddTo(CLI::App& command) {
  CLI::Option* json_flag =
      command.add_flag("--json", json, "print one JSON object per episode, and nothing else");
  command.add_flag("--quiet", quiet, "print only warnings and errors")->excludes(json_flag);
}

ProgressStyle OutputOptions::style() const {
  if (json) return ProgressStyle::kJson;
  return quiet ? ProgressStyle::kQuiet : ProgressStyle::kText;
}

int RunSession(const std::filesystem::path& folder, Network& network, const RunRecord& run,
               RunDatabase& database, ProgressStyle style) {
  const std::string name = folder.string();
  Progress progress(style, run, stdout, stderr);
  Training training(network, run, database, progress);
  training.Restore();
  progress.Note(fmt::format("{}: task {}, robot {}, profile {}, seed {}, episodes {} to {}", name,
                            run.tasks.front().task, run.robot, run.profile, run.seed,
                            training.episodes_done() + 1, run.episodes_planned));
  const StopRequest stop;
  try {
    if (training.Run(stop)) {
      progress.Note(fmt::format("finished; `trainer report {}` draws the curves", name));
      return kSuccess;
    }
  } catch (const UserError& error) {
    throw UserError(fmt::format(
        "{}; what was saved is kept, and `trainer resume {}` goes on from the last checkpoint",
        error.what(), name));
  }
  progress.Note(fmt::format("stopped; `trainer resume {}` goes on", name));
  return kStoppedBySignal + stop.signal();
}

}  // namespace runtime
