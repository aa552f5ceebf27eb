#include "runtime/live/workers/supervisor.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "runtime/base/user_error.h"
#include "runtime/core/module/end_kind_name.h"
#include "runtime/training/run/return_statistics.h"
#include "runtime/training/run/run_database.h"

namespace runtime {

struct Supervisor::Job {
  size_t run;  // index: more runs may come
  Worker worker;
  int64_t episodes_before = 0;  // when this worker began
  bool is_to_end = false;       // it was asked to, alone

  Job(size_t index, const RunProgress& progress, const WorkerWords& words)
      : run(index), worker(words(progress)), episodes_before(progress.episodes) {}
};

namespace {

std::string WhyItEnded(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  }
  return fmt::format("exit status {}", WEXITSTATUS(status));
}

RunProgressState StateOf(const RunProgress& run, RunState state) {
  if (run.episodes >= run.episodes_planned) return RunProgressState::kFinished;
  if (state == RunState::kRunning) return RunProgressState::kRunning;
  return run.episodes > 0 ? RunProgressState::kStopped : RunProgressState::kWaiting;
}

}  // namespace

void CountEpisode(const nlohmann::json& episode, RunProgress& run) {
  run.episodes = episode["episode"].get<int64_t>();
  run.last_return = episode["return"].is_number() ? episode["return"].get<double>()
                                                  : std::numeric_limits<double>::quiet_NaN();
  if (episode["end"]["kind"] != EndKindName(EndKind::kDiverged)) {
    run.best_return = std::fmax(run.best_return, run.last_return);
  }
  run.wall_seconds += episode["wall_seconds"].get<double>();
  ++run.episodes_here;
}

RunProgress ReadProgress(const std::filesystem::path& folder, std::string name) {
  RunProgress run{folder, std::move(name)};
  const RunDatabase database = RunDatabase::OpenToRead(folder);
  const auto [record, episodes] = database.ReadRunAndEpisodes();
  run.episodes_planned = record.episodes_planned;
  ReturnStatistics returns;
  for (const EpisodeRecord& episode : episodes) {
    returns.Add(episode);
    run.episodes = episode.number;
  }
  run.last_return = returns.last();
  run.best_return = returns.best();
  run.state = StateOf(run, database.ReadState());
  return run;
}

Supervisor::Supervisor(std::vector<RunProgress> runs, WorkerWords words, int jobs,
                       SupervisorListener& listener)
    : runs_(std::move(runs)),
      words_(std::move(words)),
      jobs_(static_cast<size_t>(std::max(jobs, 1))),
      listener_(listener) {}

Supervisor::~Supervisor() = default;

bool Supervisor::Run(const StopRequest& stop) {
  StartWorkers();
  while (has_workers()) Turn(stop);
  return std::ranges::all_of(
      runs_, [](const RunProgress& run) { return run.state == RunProgressState::kFinished; });
}

void Supervisor::Turn(const StopRequest& stop, int wake) {
  if (!is_stopping()) StartWorkers();  // those that were added
  Wait(wake);
  StopWorkers(stop);
  if (!is_stopping()) StartWorkers();
}

void Supervisor::Add(RunProgress run) {
  const auto known = std::ranges::find(runs_, run.name, &RunProgress::name);
  if (known == runs_.end()) {
    runs_.push_back(std::move(run));
  } else if (known->state != RunProgressState::kRunning) {
    *known = std::move(run);
  }
}

bool Supervisor::End(const std::string& name) {
  const auto run = std::ranges::find(runs_, name, &RunProgress::name);
  if (run == runs_.end()) return false;
  if (run->state == RunProgressState::kWaiting) run->state = RunProgressState::kStopped;
  for (const auto& job : running_) {
    if (&runs_[job->run] != &*run) continue;
    job->is_to_end = true;
    job->worker.Send(SIGTERM);
    return true;
  }
  return run->state == RunProgressState::kStopped;
}

void Supervisor::StartWorkers() {
  const size_t before = running_.size();
  for (size_t i = 0; i < runs_.size() && running_.size() < jobs_; ++i) {
    if (runs_[i].state != RunProgressState::kWaiting) continue;
    runs_[i].state = RunProgressState::kRunning;
    running_.push_back(std::make_unique<Job>(i, runs_[i], words_));
  }
  if (running_.size() > before) listener_.OnStart();
}

void Supervisor::Wait(int wake) {
  constexpr int kLookAtStop = 200;  // ms: how soon Ctrl-C is noticed where nothing is printed
  std::vector<pollfd> waits;
  for (const auto& job : running_) {
    waits.push_back({job->worker.output().descriptor(), POLLIN, 0});
    waits.push_back({job->worker.errors().descriptor(), POLLIN, 0});
  }
  waits.push_back({wake, POLLIN, 0});  // one that is negative is passed over
  if (poll(waits.data(), waits.size(), kLookAtStop) <= 0) return;
  for (size_t i = 0; i < running_.size(); ++i) {
    ReadFrom(*running_[i], waits[2 * i].revents, waits[2 * i + 1].revents);
  }
  std::erase_if(running_, [&](const auto& job) {
    if (!job->worker.is_silent()) return false;
    OnEnd(*job);
    return true;
  });
}

void Supervisor::ReadFrom(Job& job, short output_events, short error_events) {
  if (output_events != 0) {
    job.worker.output().Read([&](std::string_view line) { OnLine(job, line); });
  }
  if (error_events != 0) {
    job.worker.errors().Read([&](std::string_view line) {
      if (line.starts_with(kStopNotice)) return;  // the listener was told of all at once
      runs_[job.run].failure = line;
      listener_.OnMessage(runs_[job.run], line);
    });
  }
}

void Supervisor::OnLine(Job& job, std::string_view line) {
  const auto json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object()) return;  // cut off by a crash
  RunProgress& run = runs_[job.run];
  if (json.contains("episode")) CountEpisode(json, run);
  listener_.OnLine(run, line);
}

void Supervisor::OnEnd(Job& job) {
  RunProgress& run = runs_[job.run];
  const int status = job.worker.WaitStatus();
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
    run.state = RunProgressState::kFinished;
    return;
  }
  if (is_stopping() || job.is_to_end) {
    run.state = RunProgressState::kStopped;
    return;
  }
  // A worker that says what is wrong would say it again.
  const bool is_told = WIFEXITED(status) && WEXITSTATUS(status) < 128;
  const bool is_fruitless = run.episodes <= job.episodes_before;
  run.restarts = is_fruitless ? run.restarts + 1 : 1;
  if (is_told || run.restarts >= kMaxFruitlessStarts) {
    run.state = RunProgressState::kFailed;
    if (!is_told) run.failure = fmt::format("its worker ended by {}", WhyItEnded(status));
    listener_.OnMessage(run, fmt::format("given up: {}", run.failure));
    return;
  }
  run.state = RunProgressState::kWaiting;
  listener_.OnMessage(run,
                      fmt::format("its worker ended by {}; it continues from its last checkpoint",
                                  WhyItEnded(status)));
}

void Supervisor::StopWorkers(const StopRequest& stop) {
  constexpr std::chrono::seconds kPause{1};
  const int wanted = stop.is_urgent() ? 2 : (stop.signal() != 0 ? 1 : 0);
  const auto now = std::chrono::steady_clock::now();
  if (signals_sent_ < wanted) {
    ++signals_sent_;
    listener_.OnStopping(signals_sent_ == 2);
  } else if (wanted < 2 || now - last_signal_ < kPause) {
    return;
  }
  // Two that reach a worker together are one for it: the second is repeated until it has ended.
  last_signal_ = now;
  for (const auto& job : running_) job->worker.Send(stop.signal());
}

}  // namespace runtime
