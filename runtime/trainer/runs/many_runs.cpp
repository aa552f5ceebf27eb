#include "runtime/trainer/runs/many_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <thread>

#include "base/text/print.h"
#include "runtime/base/folder_lock.h"
#include "runtime/base/in_parallel.h"
#include "runtime/core/task/plugin_watch.h"
#include "runtime/live/workers/run_table.h"
#include "runtime/live/workers/supervisor.h"
#include "runtime/trainer/commands.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/stop_request.h"

namespace runtime {
namespace {

// Of names that differ in their number only, the shorter one first: seed2 before seed10.
bool ComesBefore(const std::filesystem::path& a, const std::filesystem::path& b) {
  const std::string first = a.filename().string();
  const std::string second = b.filename().string();
  const auto stem = [](const std::string& name) {
    return name.substr(0, name.find_last_not_of("0123456789") + 1);
  };
  if (stem(first) != stem(second)) return stem(first) < stem(second);
  return std::pair(first.size(), first) < std::pair(second.size(), second);
}

// Those in `folder`, and in the folders in it that hold no run, in the order of their names. None
// where `folder` is a run itself.
std::vector<std::filesystem::path> FoldersBelow(const std::filesystem::path& folder) {
  if (RunDatabase::Exists(folder)) return {};
  std::vector<std::filesystem::path> folders;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.is_directory(error)) folders.push_back(entry.path());
  }
  std::ranges::sort(folders, ComesBefore);
  std::vector<std::filesystem::path> found;
  for (const std::filesystem::path& each : folders) {
    found.push_back(each);
    std::ranges::copy(FoldersBelow(each), std::back_inserter(found));
  }
  return found;
}

RunProgress ReadProgressOrFailure(const std::filesystem::path& folder,
                                  const std::filesystem::path& run) {
  const std::string name = run.lexically_relative(folder).string();
  try {
    return ReadProgress(run, name);
  } catch (const UserError& error) {
    RunProgress progress{run, name};
    progress.state = RunProgressState::kFailed;
    progress.failure = error.what();
    return progress;
  }
}

}  // namespace

std::filesystem::path SeedFolder(const std::filesystem::path& folder, uint64_t seed) {
  return folder / fmt::format("seed{}", seed);
}

std::vector<std::filesystem::path> FindRuns(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> runs;
  std::ranges::copy_if(FoldersBelow(folder), std::back_inserter(runs), RunDatabase::Exists);
  return runs;
}

void WarnOfUnfinishedRuns(const std::filesystem::path& folder) {
  for (const std::filesystem::path& each : FoldersBelow(folder)) {
    // While a trainer makes it, all is well.
    if (!RunDatabase::IsUnfinished(each) || FolderLock::IsTaken(each)) continue;
    text::Print(stderr,
                "warning: {0}: not a run: the trainer was stopped while it created it; `trainer "
                "study` or `trainer train TASK --out {0}` creates it, or delete the folder\n",
                each.string());
  }
}

std::vector<RunProgress> ReadProgressOrFailures(const std::filesystem::path& folder,
                                                const std::vector<std::filesystem::path>& runs) {
  std::vector<RunProgress> progress(runs.size());
  InParallel(runs.size(), [&](size_t i) { progress[i] = ReadProgressOrFailure(folder, runs[i]); });
  for (const RunProgress& run : progress) {
    if (!run.failure.empty()) text::Print(stderr, "warning: {}\n", run.failure);
  }
  return progress;
}

void AddJobsOption(command_line::Command& command, int& jobs, const std::string& what) {
  command.AddOption("--jobs", jobs, fmt::format("{}; by default one per core", what))
      .Range(1, 1024);
}

int JobsOrCores(int jobs) {
  return jobs > 0 ? jobs : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

int EpisodesAtATime(int jobs) {
  constexpr int kMost = PluginWatch::kMostThreads - 1;
  return std::min(JobsOrCores(jobs), kMost);
}

std::vector<RunProgress> RunsToTrain(const std::filesystem::path& folder,
                                     const std::vector<std::filesystem::path>& runs) {
  std::vector<RunProgress> found = ReadProgressOrFailures(folder, runs);
  for (RunProgress& run : found) {
    if (!run.is_over()) run.state = RunProgressState::kWaiting;
  }
  return found;
}

WorkerWords WordsToTrain(const std::vector<RunProgress>& runs, int jobs) {
  const auto waiting = std::ranges::count(runs, RunProgressState::kWaiting, &RunProgress::state);
  const int64_t share = std::max<int64_t>(1, jobs / std::max<int64_t>(1, waiting));
  return [share](const RunProgress& run) -> std::vector<std::string> {
    return {"resume", run.folder.string(), "--json", "--jobs", std::to_string(share)};
  };
}

int TrainRuns(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& runs,
              int jobs, const OutputOptions& output) {
  jobs = JobsOrCores(jobs);
  WarnOfUnfinishedRuns(folder);
  RunTablePrinter printer(output.style(), jobs, stdout, stderr);
  std::vector<RunProgress> progress = RunsToTrain(folder, runs);
  const WorkerWords words = WordsToTrain(progress, jobs);
  Supervisor supervisor(std::move(progress), words, jobs, printer);
  printer.Follow(supervisor.runs());
  const StopRequest stop(StopRequest::Second::kIsNoted);
  const bool are_all_finished = supervisor.Run(stop);
  printer.Finish();
  if (are_all_finished) return kSuccess;
  if (stop.signal() == 0) return kFailed;
  if (IsForPeople(output.style())) {
    text::Print("stopped; `trainer resume {}` continues\n", folder.string());
  }
  return kStoppedBySignal + stop.signal();
}

}  // namespace runtime
