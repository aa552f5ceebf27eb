// What it costs a run that its page is open, in CPU time of the trainer alone. A browser would draw
// on the same machine and slow down everything on it, so that all that the page asks for is asked
// for here by threads that draw nothing.
//
// Whatever else the machine does makes the same work take longer, never shorter. The run is made
// again and again, watched and unwatched in turns; it computes the same each time, so that of each
// episode the shortest time counts.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include "runtime/base/scratch_folder.h"
#include "runtime/base/user_error.h"
#include "runtime/live/client/client.h"
#include "runtime/live/server/control_socket.h"
#include "runtime/training/run/run_database.h"

namespace runtime {
namespace {

constexpr const char* kEpisodes = "60";
constexpr int kTurns = 12;
constexpr std::chrono::seconds kBetweenEpisodes{17};  // that a page shows in real time

enum Watching { kNobody, kWholeEpisodes, kInstants };

pid_t StartTrainer(const std::filesystem::path& run) {
  std::vector<std::string> words = {TRAINER,     "train",     SOURCE_DIR "/tasks/crawling.task",
                                    "--profile", "fast-tree", "--episodes",
                                    kEpisodes,   "--quiet",   "--jobs",
                                    "1",         "--out",     run.string()};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t process = 0;
  if (posix_spawn(&process, TRAINER, nullptr, nullptr, arguments.data(), environ) != 0) return 0;
  return process;
}

// Until the trainer ends or `is_over`.
template <class Action>
void WhileThere(const std::filesystem::path& run, const std::atomic<bool>& is_over,
                const Action& action) {
  while (!is_over && !std::filesystem::exists(run / "control.json")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  try {
    while (!is_over) action();
  } catch (const UserError&) {  // it has ended
  }
}

void Send(int socket, const std::string& text) {
  (void)!send(socket, text.data(), text.size(), MSG_NOSIGNAL);
}

// A WebSocket's message of a client, masked with zeros.
std::string Frame(const std::string& word) {
  const std::string head = {'\x81', static_cast<char>(0x80 | word.size()), 0, 0, 0, 0};
  return head + word;
}

// Wishes to see what a page wishes, and reads it.
void View(const std::filesystem::path& run, Watching watching, const std::atomic<bool>& is_over) {
  const Descriptor socket = ConnectToTrainer(OpenRunFolder(run));
  Send(socket.get(),
       "GET /api/view HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
       "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Version: 13\r\n\r\n");
  const std::string wish = Frame(watching == kInstants ? "instants" : "episode");
  std::string buffer(1 << 16, '\0');
  std::chrono::steady_clock::time_point asked;
  bool is_accepted = false;
  for (pollfd wait{socket.get(), POLLIN, 0}; !is_over;) {
    const auto now = std::chrono::steady_clock::now();
    const bool is_first = is_accepted && asked == std::chrono::steady_clock::time_point();
    if (is_first || (is_accepted && watching == kWholeEpisodes && now - asked > kBetweenEpisodes)) {
      Send(socket.get(), wish);
      asked = now;
    }
    if (poll(&wait, 1, 100) <= 0) continue;
    if (recv(socket.get(), buffer.data(), buffer.size(), 0) <= 0) return;
    is_accepted = true;
  }
}

// All that an open page asks for.
class OpenPage {
 public:
  OpenPage(const std::filesystem::path& run, Watching watching)
      : events_([=, this] {
          WhileThere(run, is_over_, [&] { FollowEvents(run, [](const auto&) {}); });
        }),
        status_([=, this] {
          WhileThere(run, is_over_, [&] {
            Ask(run, {"status", nlohmann::json::object()});
            std::this_thread::sleep_for(std::chrono::seconds(1));
          });
        }),
        view_([=, this] { WhileThere(run, is_over_, [&] { View(run, watching, is_over_); }); }) {}
  OpenPage(const OpenPage&) = delete;
  OpenPage& operator=(const OpenPage&) = delete;
  ~OpenPage() {
    is_over_ = true;
    for (std::thread* thread : {&events_, &status_, &view_}) thread->join();
  }

 private:
  std::atomic<bool> is_over_ = false;
  std::thread events_, status_, view_;
};

double SecondsOf(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// The least that the same work has taken: CPU time [s].
class Least {
 public:
  // Of a run that has ended.
  void Add(const std::filesystem::path& run, double whole) {
    whole_ = std::min(whole_, whole);
    const std::vector<EpisodeRecord> episodes = RunDatabase::Open(run).ReadEpisodes();
    episodes_.resize(episodes.size(), std::numeric_limits<double>::infinity());
    steps_.resize(episodes.size());
    for (size_t i = 0; i < episodes.size(); ++i) {
      episodes_[i] = std::min(episodes_[i], episodes[i].cpu_seconds);
      steps_[i] = episodes[i].steps;
    }
  }

  // Of the thread that trains, in all episodes.
  double training() const { return std::accumulate(episodes_.begin(), episodes_.end(), 0.0); }
  // Of all threads, from the start of the trainer to its end.
  double whole() const { return whole_; }
  bool IsOfTheSameWork(const Least& other) const { return steps_ == other.steps_; }

 private:
  std::vector<double> episodes_;
  std::vector<int64_t> steps_;
  double whole_ = std::numeric_limits<double>::infinity();
};

void MakeRun(Watching watching, Least& least) {
  const ScratchFolder folder;
  const std::filesystem::path run = folder.path() / "run";
  const pid_t trainer = StartTrainer(run);
  int status = 0;
  rusage usage{};
  {
    std::unique_ptr<OpenPage> page;
    if (watching != kNobody) page = std::make_unique<OpenPage>(run, watching);
    wait4(trainer, &status, 0, &usage);
  }
  if (status != 0) throw UserError("the trainer failed");
  least.Add(run, SecondsOf(usage.ru_utime) + SecondsOf(usage.ru_stime));
}

double PercentMore(double watched, double alone) { return 100 * (watched / alone - 1); }

// The counters say how much more a watched run takes than an unwatched one, in percent.
void TrainingWatchedBy(benchmark::State& state) {
  const auto watching = static_cast<Watching>(state.range(0));
  Least alone, watched;
  for (auto _ : state) {
    MakeRun(kNobody, alone);
    MakeRun(watching, watched);
    state.SetIterationTime(watched.training());
  }
  if (!watched.IsOfTheSameWork(alone)) state.SkipWithError("who watches changes the run");
  state.counters["training_more"] = PercentMore(watched.training(), alone.training());
  state.counters["whole_more"] = PercentMore(watched.whole(), alone.whole());
}
BENCHMARK(TrainingWatchedBy)
    ->ArgName("nobody/episodes/instants")
    ->Arg(kNobody)
    ->Arg(kWholeEpisodes)
    ->Arg(kInstants)
    ->UseManualTime()
    ->Iterations(kTurns)
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace runtime

BENCHMARK_MAIN();
