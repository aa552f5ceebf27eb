#include "runtime/trainer/train/probe_search.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "runtime/core/module/end_kind_name.h"
#include "runtime/live/workers/supervisor.h"
#include "runtime/trainer/runs/many_runs.h"
#include "runtime/trainer/train/probe_progress.h"
#include "runtime/trainer/train/probe_schedule.h"
#include "runtime/training/run/run_database.h"

namespace runtime {
namespace {

using Clock = std::chrono::steady_clock;
using Folders = std::vector<std::filesystem::path>;

double SecondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Those that were to come furthest: the others were given up in a call before.
Folders GoingOn(const std::vector<RunProgress>& runs) {
  const int64_t most = std::ranges::max(runs, {}, &RunProgress::episodes_planned).episodes_planned;
  Folders left;
  for (const RunProgress& run : runs) {
    if (run.episodes_planned == most) left.push_back(run.folder);
  }
  return left;
}

double BestReturn(const std::filesystem::path& run) {
  double best = -std::numeric_limits<double>::infinity();
  for (const EpisodeRecord& episode : RunDatabase::OpenToRead(run).ReadEpisodes()) {
    const bool is_sound = episode.active.end_kind != EndKindName(EndKind::kDiverged);
    if (is_sound) best = std::max(best, episode.active.episode_return);
  }
  return best;
}

// As many of them as `count` says.
Folders BestOf(Folders runs, size_t count) {
  if (count == runs.size()) return runs;
  std::map<std::filesystem::path, double> best;
  for (const std::filesystem::path& run : runs) best[run] = BestReturn(run);
  std::ranges::stable_sort(runs, std::greater(), [&](const auto& run) { return best[run]; });
  runs.resize(count);
  return runs;
}

}  // namespace

ProbeEnd Search(const std::filesystem::path& folder, const Folders& runs, const ProbeBudget& budget,
                int jobs, ProgressStyle style, const StopRequest& stop) {
  const Clock::time_point start = Clock::now();
  ProbeProgress progress(style, budget);
  const std::vector<RunProgress> before = RunsToTrain(folder, runs);
  int64_t done = std::ranges::max(before, {}, &RunProgress::episodes).episodes;
  Folders left = GoingOn(before);
  ProbeSchedule schedule(budget.seconds, left.size(), left.size() < runs.size());
  const bool is_by_episodes = budget.episodes > 0;
  if (is_by_episodes) left = runs;
  ProbeSchedule::Round round =
      is_by_episodes ? ProbeSchedule::Round{budget.episodes - done, runs.size()} : schedule.First();
  while (round.episodes > 0) {
    const Clock::time_point start_of_round = Clock::now();
    left = BestOf(std::move(left), round.searches);
    done += round.episodes;
    for (const auto& run : left) RunDatabase::Open(run).SetEpisodesPlanned(done);
    std::vector<RunProgress> searches = RunsToTrain(folder, left);
    const WorkerWords words = WordsToTrain(searches, jobs);
    Supervisor supervisor(std::move(searches), words, jobs, progress);
    progress.Follow(supervisor.runs());
    const bool are_all_finished = supervisor.Run(stop);
    progress.Erase();
    if (!are_all_finished) return stop.signal() != 0 ? ProbeEnd::kStopped : ProbeEnd::kFailed;
    if (is_by_episodes) break;
    round = schedule.Next(SecondsSince(start), SecondsSince(start_of_round), round.episodes, done);
  }
  return ProbeEnd::kDone;
}

}  // namespace runtime
