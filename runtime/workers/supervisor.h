// Many runs side by side: each in a worker process of its own, so that what happens to one never
// reaches another.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/run/stop_request.h"
#include "runtime/workers/worker.h"

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
  double best_return = 0;     // -infinity before the first episode
  double wall_seconds = 0;    // of the episodes done since the supervisor began
  int64_t episodes_here = 0;  // as many are these
  int restarts = 0;
  std::string failure{};  // why it was given up
};

// How far the run in `folder` is, and whether a trainer works on it.
RunProgress ReadProgress(const std::filesystem::path& folder, std::string name);

// What a user gets to see, as it happens.
class SupervisorListener {
 public:
  virtual ~SupervisorListener() = default;
  // `json`: the line of the worker, see EpisodeJson().
  virtual void OnEpisode(const RunProgress& run, std::string_view json) = 0;
  // What a worker prints on standard error, and what became of it.
  virtual void OnMessage(const RunProgress& run, std::string_view text) = 0;
};

class Supervisor {
 public:
  // A worker that ends without having been asked is started again, from its last checkpoint; this
  // often in a row without a single new episode, and its run is given up.
  static constexpr int kMaxFruitlessStarts = 3;

  // `runs`: their folders, each with a run, somewhere in `folder`. At most `jobs` workers at a
  // time.
  Supervisor(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& runs,
             int jobs, SupervisorListener& listener);
  ~Supervisor();

  // Until all runs are finished or given up, or a stop is requested: then the workers end after
  // their present episode, and everything can be gone on with. Returns whether all are finished.
  bool Run(const StopRequest& stop);

  const std::vector<RunProgress>& runs() const { return runs_; }

 private:
  struct Job;

  void StartWorkers();
  void Wait();
  void ReadFrom(Job& job, short output_events, short error_events);
  void OnLine(Job& job, std::string_view line);
  void OnEnd(Job& job);
  void StopWorkers(int signal);

  std::vector<RunProgress> runs_;
  const size_t jobs_;
  SupervisorListener& listener_;
  std::vector<std::unique_ptr<Job>> running_;
  bool is_stopping_ = false;
};

}  // namespace runtime
