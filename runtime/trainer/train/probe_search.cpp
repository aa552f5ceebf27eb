#include "runtime/trainer/train/probe_search.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "runtime/live/workers/supervisor.h"
#include "runtime/trainer/runs/many_runs.h"
#include "runtime/trainer/train/probe_progress.h"
#include "runtime/training/run/run_database.h"

namespace runtime {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int64_t kFirstRound = 10;  // episodes of each search, which show how long they take

double SecondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// As many as the search that is furthest has.
int64_t EpisodesDone(const std::filesystem::path& folder,
                     const std::vector<std::filesystem::path>& runs) {
  int64_t most = 0;
  for (const RunProgress& run : RunsToTrain(folder, runs)) most = std::max(most, run.episodes);
  return most;
}

// Of the next round: half of those for which there is time, since episodes get longer as motions
// get better. 0: it is not worth another round.
int64_t NextRound(double seconds_left, double seconds_of_round, int64_t round, int64_t done) {
  const double possible = seconds_left / seconds_of_round * static_cast<double>(round);
  if (possible < 1 + static_cast<double>(done) / 50) return 0;
  return std::max<int64_t>(1, std::llround(possible / 2));
}

}  // namespace

ProbeEnd Search(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& runs,
                const ProbeBudget& budget, int jobs, ProgressStyle style, const StopRequest& stop) {
  const Clock::time_point start = Clock::now();
  ProbeProgress progress(style, budget);
  int64_t done = EpisodesDone(folder, runs);
  int64_t round = budget.episodes > 0 ? budget.episodes - done : kFirstRound;
  while (round > 0) {
    const Clock::time_point start_of_round = Clock::now();
    done += round;
    for (const std::filesystem::path& run : runs) RunDatabase::Open(run).SetEpisodesPlanned(done);
    Supervisor supervisor(RunsToTrain(folder, runs), WordsToTrain, jobs, progress);
    progress.Follow(supervisor.runs());
    const bool are_all_finished = supervisor.Run(stop);
    progress.Erase();
    if (!are_all_finished) return stop.signal() != 0 ? ProbeEnd::kStopped : ProbeEnd::kFailed;
    if (budget.episodes > 0) break;
    round =
        NextRound(budget.seconds - SecondsSince(start), SecondsSince(start_of_round), round, done);
  }
  return ProbeEnd::kDone;
}

}  // namespace runtime
