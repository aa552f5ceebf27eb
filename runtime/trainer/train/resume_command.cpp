#include <memory>
#include <optional>

#include "runtime/trainer/commands.h"
#include "runtime/trainer/runs/guard.h"
#include "runtime/trainer/runs/many_runs.h"
#include "runtime/trainer/runs/one_run.h"
#include "runtime/training/run/run_database.h"

namespace runtime {
namespace {

struct ResumeOptions {
  std::filesystem::path folder;
  std::optional<int64_t> episodes;
  SessionOptions session;
};

int ResumeOne(const ResumeOptions& options) {
  return RunGuarded([&] { return ResumeOneRun(options.folder, options.episodes, options.session); },
                    [&](const std::filesystem::path& run, Pace pace) {
                      return ResumeOneRun(run, std::nullopt, options.session.At(pace));
                    });
}

// In a folder of runs the new number of episodes is set first, for all of them.
int ResumeMany(const ResumeOptions& options, const std::vector<std::filesystem::path>& runs) {
  if (options.episodes) {
    for (const std::filesystem::path& folder : runs) {
      try {
        RunDatabase database = RunDatabase::Open(folder);
        RunRecord run = database.ReadRun();
        PlanEpisodes(options.episodes, database, run);
      } catch (const UserError&) {
        // One that cannot be opened keeps none of the others from going on, and says why then.
      }
    }
  }
  return TrainRuns(options.folder, runs, options.session.jobs, options.session.output);
}

int Resume(const ResumeOptions& options) {
  const std::vector<std::filesystem::path> runs = FindRuns(options.folder);
  return runs.empty() ? ResumeOne(options) : ResumeMany(options, runs);
}

}  // namespace

void AddResumeCommand(command_line::Command& program) {
  const auto options = std::make_shared<ResumeOptions>();
  command_line::Command& command =
      program.AddCommand("resume", "Continues a run, or all runs in a folder, bit for bit.");
  command.AddOption("DIR", options->folder, "folder of the run, or of many runs").Required();
  command
      .AddOption("--episodes", options->episodes,
                 "how many episodes the run is to have in total; by default as planned")
      .Range(1, 1'000'000'000);
  AddJobsOption(command, options->session.jobs,
                "how many runs to train, or episodes of one run to run, at a time");
  options->session.AddTo(command);
  command.OnRun([options] { return Resume(*options); });
}

}  // namespace runtime
