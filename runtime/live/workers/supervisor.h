// Many runs side by side: each in a worker process of its own, so that what happens to one never
// reaches another.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/live/workers/worker.h"
#include "runtime/training/run/stop_request.h"

namespace runtime {

enum class RunProgressState { kWaiting, kRunning, kFinished, kStopped, kFailed };

// How far one run is.
struct RunProgress {
  std::filesystem::path folder;
  std::string name;  // of the folder, as seen from the one that all are in
  RunProgressState state = RunProgressState::kWaiting;
  int64_t episodes = 0;  // done
  int64_t episodes_planned = 0;
  double last_return = 0;
  double best_return = -std::numeric_limits<double>::infinity();  // before the first episode
  double wall_seconds = 0;    // of the episodes done since the supervisor began
  int64_t episodes_here = 0;  // as many are these
  int restarts = 0;
  std::string failure{};  // why it was given up

  bool is_over() const {
    return state == RunProgressState::kFinished || state == RunProgressState::kFailed;
  }
};

// The run has done one more, of which a worker has printed this. As everywhere, the return of one
// that has diverged is not a best one (runtime/training/run/return_statistics.h).
void CountEpisode(const nlohmann::json& episode, RunProgress& run);

// How far the run in `folder` is, and whether a trainer works on it.
RunProgress ReadProgress(const std::filesystem::path& folder, std::string name);

// What a user gets to see, as it happens.
class SupervisorListener {
 public:
  virtual ~SupervisorListener() = default;
  // Runs that have waited are running now.
  virtual void OnStart() = 0;
  // `json`: a line of the worker, of an episode (see EpisodeJson()) or what came out in the end.
  virtual void OnLine(const RunProgress& run, std::string_view json) = 0;
  // What a worker prints on standard error, and what became of it.
  virtual void OnMessage(const RunProgress& run, std::string_view text) = 0;
  // The workers were asked to end after their current episodes, or `at_once`.
  virtual void OnStopping(bool at_once) = 0;
};

// The words after `trainer` with which a worker takes up a run. It prints a line of JSON for each
// episode, goes on where it was when it is called again, and ends after the current episode when it
// is asked to.
using WorkerWords = std::function<std::vector<std::string>(const RunProgress& run)>;

class Supervisor {
 public:
  // A worker that ends without having been asked is started again, from its run's last checkpoint;
  // this often in a row without a single new episode, and its run is given up.
  static constexpr int kMaxFruitlessStarts = 3;

  // Those of the `runs` that are waiting get workers, at most `jobs` at a time.
  Supervisor(std::vector<RunProgress> runs, WorkerWords words, int jobs,
             SupervisorListener& listener);
  ~Supervisor();

  // Until all runs are finished or given up, or a stop is requested: then the workers end after
  // their current episode, or at once where it is urgent, and everything can be gone on with.
  // Returns whether all are finished.
  bool Run(const StopRequest& stop);

  // For those whose runs come and go. Looks after the workers once, for at most a fifth of a
  // second, or until `wake` can be read (-1: nothing else is waited for).
  void Turn(const StopRequest& stop, int wake = -1);
  // One more run, or one that has no worker now and is to go on.
  void Add(RunProgress run);
  // Asks the worker of this run to end after the current episode; takes one that waits off its
  // place. Returns whether it is one of them.
  bool End(const std::string& name);
  bool has_workers() const { return !running_.empty(); }

  const std::vector<RunProgress>& runs() const { return runs_; }

 private:
  struct Job;

  void StartWorkers();
  void Wait(int wake);
  void ReadFrom(Job& job, short output_events, short error_events);
  void OnLine(Job& job, std::string_view line);
  void OnEnd(Job& job);
  void StopWorkers(const StopRequest& stop);
  bool is_stopping() const { return signals_sent_ > 0; }
  std::chrono::steady_clock::time_point last_signal_;

  std::vector<RunProgress> runs_;
  const WorkerWords words_;
  const size_t jobs_;
  SupervisorListener& listener_;
  std::vector<std::unique_ptr<Job>> running_;
  int signals_sent_ = 0;  // to each worker
};

}  // namespace runtime
