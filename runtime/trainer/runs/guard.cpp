#include "runtime/trainer/runs/guard.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "base/text/print.h"
#include "runtime/base/sandbox.h"
#include "runtime/base/scratch_folder.h"
#include "runtime/base/user_error.h"
#include "runtime/core/task/plugin_watch.h"
#include "runtime/live/control/journal.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/runs/loop_detector.h"
#include "runtime/training/run/record_error.h"
#include "runtime/training/run/run_database.h"

namespace runtime {
namespace {

constexpr int kMillisecondsBetweenLooks = 500;

// How the child means to end. An exit status alone does not tell: any plugin can exit.
enum class Intent { kNone, kEnd, kStartAgain };

// What both processes see.
struct SharedPage {
  PluginWatch watch;
  std::atomic<Intent> intent = Intent::kNone;
  char run[PATH_MAX] = "";
};

SharedPage* shared_page = nullptr;
volatile pid_t guarded_child = 0;

SharedPage* MakeSharedPage() {
  void* memory =
      mmap(nullptr, sizeof(SharedPage), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) {
    throw UserError(fmt::format("cannot share memory: {}", std::strerror(errno)));
  }
  return new (memory) SharedPage;
}

bool IsBeingDebugged() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("TracerPid:")) return line != "TracerPid:\t0";
  }
  return false;
}

void PassOn(int signal) {
  if (guarded_child > 0) kill(guarded_child, signal);
}

// Ctrl-Z reaches only us: the child has a process group of its own, so that Ctrl-C reaches it once.
void StandStill(int) {
  PassOn(SIGSTOP);
  raise(SIGSTOP);
  PassOn(SIGCONT);
}

// Restores what was there before.
class PassedSignals {
 public:
  PassedSignals() {
    Handle(SIGINT, PassOn, old_[0]);
    Handle(SIGTERM, PassOn, old_[1]);
    Handle(SIGTSTP, StandStill, old_[2]);
  }
  PassedSignals(const PassedSignals&) = delete;
  PassedSignals& operator=(const PassedSignals&) = delete;
  ~PassedSignals() {
    sigaction(SIGINT, &old_[0], nullptr);
    sigaction(SIGTERM, &old_[1], nullptr);
    sigaction(SIGTSTP, &old_[2], nullptr);
  }

 private:
  static void Handle(int signal, void (*handler)(int), struct sigaction& old) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigaction(signal, &action, &old);
  }
  struct sigaction old_[3];
};

// Waits for the child's end; kills it if a plugin does not come back. Returns whether it did that.
bool WaitForEnd(pid_t child, const PluginWatch& watch) {
  const auto process = static_cast<int>(syscall(SYS_pidfd_open, child, 0));
  LoopDetector detector(child);
  bool is_killed = false;
  pollfd descriptor{process, POLLIN, 0};
  while (process >= 0) {
    const int ready = poll(&descriptor, 1, kMillisecondsBetweenLooks);
    if (ready > 0) break;
    if (ready == 0 && detector.IsLooping(watch) && !is_killed) {
      is_killed = true;
      kill(child, SIGKILL);
    }
  }
  if (process >= 0) close(process);
  return is_killed;
}

// Signals that come while the child is made wait until they can be passed on to it: it may have
// printed something, and a user may have answered, before this process is ready.
class HeldSignals {
 public:
  HeldSignals() {
    sigset_t held;
    sigemptyset(&held);
    for (const int signal : {SIGINT, SIGTERM, SIGTSTP}) sigaddset(&held, signal);
    sigprocmask(SIG_BLOCK, &held, &before_);
  }
  ~HeldSignals() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

 private:
  sigset_t before_;
};

struct End {
  int status = 0;  // as waitpid() gives it
  bool was_looping = false;
};

// Returns only in the parent; in the child `is_child` is true.
End RunChild(bool& is_child) {
  const pid_t parent = getpid();
  std::fflush(nullptr);  // or else both would print what waits
  std::optional<HeldSignals> held(std::in_place);
  const pid_t child = fork();
  if (child < 0) throw UserError(fmt::format("cannot start a process: {}", std::strerror(errno)));
  if (child == 0) {
    is_child = true;
    held.reset();
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);
    SetPluginWatch(shared_page->watch);
    return {};
  }
  guarded_child = child;
  const PassedSignals passed_signals;
  held.reset();
  End end;
  end.was_looping = WaitForEnd(child, shared_page->watch);
  while (waitpid(child, &end.status, 0) < 0 && errno == EINTR) {
  }
  guarded_child = 0;
  return end;
}

std::string Reason(const End& end) {
  if (end.was_looping) {
    return fmt::format("it did not return within {} s", LoopDetector::kPatience);
  }
  if (WIFEXITED(end.status)) {
    return fmt::format("it ended the program, with exit status {}", WEXITSTATUS(end.status));
  }
  const int signal = WTERMSIG(end.status);
  return fmt::format("crash: {}", strsignal(signal));
}

// Not a user who stops it, nor a machine that is out of memory.
bool IsCrash(const End& end) {
  if (end.was_looping || WIFEXITED(end.status)) return true;
  const int signal = WTERMSIG(end.status);
  return signal == SIGSEGV || signal == SIGBUS || signal == SIGFPE || signal == SIGILL ||
         signal == SIGABRT;
}

void Say(const std::string& text) { text::Print(stderr, "warning: {}\n", text); }

bool RanSideBySide(const PluginWatch& watch) {
  return std::any_of(watch.threads.begin() + 1, watch.threads.end(),
                     [](const PluginWatch::Thread& thread) { return thread.id != 0; });
}

// Makes the run continue without what has brought its process down, or in a way in which that will
// be found out. Returns whether it can.
bool RemoveCause(const End& end, Pace& pace) {
  const PluginWatch& watch = shared_page->watch;
  if (watch.loading_thread != 0) {
    Say(fmt::format("{}: a task could not be loaded ({}); continuing without it", shared_page->run,
                    Reason(end)));
    return true;
  }
  if (RanSideBySide(watch)) {
    Say(fmt::format("{}: {}; continuing from the last checkpoint, one episode at a time",
                    shared_page->run, Reason(end)));
    pace = Pace::kOneAtATime;
    return true;
  }
  const int64_t running = watch.threads.front().running;
  RunDatabase database = RunDatabase::Open(shared_page->run);
  // A graph that calls itself without end may fail inside of a plugin as well, and without its
  // first task the run is over: the last change is blamed first.
  const bool is_first_task = running == database.ReadRun().tasks.front().id;
  if ((running == 0 || is_first_task) && QuarantineLastChange(database, Reason(end))) {
    Say(fmt::format(
        "{}: {}; the last change is undone, and the run continues from the last checkpoint",
        shared_page->run, Reason(end)));
    return true;
  }
  if (running == 0) return false;
  QuarantineTask(database, running, Reason(end));
  Say(fmt::format(
      "{}: the task `{}` has failed ({}); continuing without it from the last checkpoint",
      shared_page->run, TaskWithId(database.ReadRun(), running).task, Reason(end)));
  return true;
}

bool CanGoOn(const End& end, Pace& pace) {
  pace = Pace::kAsAsked;
  const Intent intent = shared_page->intent;
  if (intent != Intent::kNone) return intent == Intent::kStartAgain;
  if (shared_page->run[0] == '\0' || !IsCrash(end)) return false;
  try {
    return RemoveCause(end, pace);
  } catch (const RecordError& error) {
    throw UserError(
        fmt::format("{0}: {1}, and that cannot be recorded: {2}; then `trainer resume {0}` "
                    "continues from the last checkpoint",
                    shared_page->run, Reason(end), error.what()));
  }
}

std::string EpisodesText(int64_t first, int64_t last) {
  if (last < first) return "nothing";
  return first == last ? fmt::format("episode {}", first)
                       : fmt::format("episodes {} to {}", first, last);
}

// What is left of a run that was told to stop at once.
void SayWhatIsKept(const std::filesystem::path& run) {
  const RunDatabase database = RunDatabase::OpenToRead(run);
  const std::vector<EpisodeRecord> episodes = database.ReadEpisodes();
  const int64_t kept = database.ReadCheckpointEpisode();
  const int64_t present = (episodes.empty() ? 0 : episodes.back().number) + 1;
  text::Print(
      stderr,
      "stopped at once; kept: {}; lost: {}, which `trainer resume {}` repeats, bit for bit\n",
      EpisodesText(1, kept), EpisodesText(kept + 1, present),
      run.lexically_proximate(std::filesystem::current_path()).string());
}

// By a second signal: the first one ends the run after the current episode.
bool WasStoppedAtOnce(const End& end) {
  if (!WIFSIGNALED(end.status)) return false;
  const int signal = WTERMSIG(end.status);
  return signal == SIGINT || signal == SIGTERM;
}

int StatusOf(const End& end) {
  if (WIFEXITED(end.status)) {
    if (shared_page->intent != Intent::kNone) return WEXITSTATUS(end.status);
    text::Print(stderr,
                "trainer: error: the training process has exited (exit status {}), which no task "
                "built by taskc makes it do; what was saved is kept\n",
                WEXITSTATUS(end.status));
    return kFailed;
  }
  const int signal = WTERMSIG(end.status);
  std::signal(signal, SIG_DFL);
  raise(signal);  // whoever waits for us is to see what has happened
  return 128 + signal;
}

// For the files of the child, which is not to reach those of others. It is removed by the process
// that has made it, however the child ends.
class TemporaryFolder {
 public:
  TemporaryFolder() : owner_(getpid()), folder_(std::make_unique<ScratchFolder>()) {
    setenv("TMPDIR", folder_->path().c_str(), 1);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    [[maybe_unused]] static ScratchFolder* of_the_guard = nullptr;
    if (getpid() != owner_) of_the_guard = folder_.release();
  }

 private:
  pid_t owner_;
  std::unique_ptr<ScratchFolder> folder_;
};

// In the child: whichever way `work` ends, that is the child's own end.
template <class Work>
int RunToTheEnd(const Work& work) {
  struct Announcement {
    ~Announcement() {
      Intent none = Intent::kNone;
      shared_page->intent.compare_exchange_strong(none, Intent::kEnd);
    }
  } const announcement;
  return work();
}

}  // namespace

int RunGuarded(const std::function<int()>& train,
               const std::function<int(const std::filesystem::path& run, Pace pace)>& again) {
  WarnWhereSandboxIsWeak();
  const TemporaryFolder temporary;
  if (IsBeingDebugged()) return train();
  shared_page = MakeSharedPage();
  bool is_child = false;
  End end = RunChild(is_child);
  if (is_child) return RunToTheEnd(train);
  Pace pace = Pace::kAsAsked;
  while (CanGoOn(end, pace)) {
    const std::filesystem::path run = shared_page->run;
    new (shared_page) SharedPage;
    end = RunChild(is_child);
    if (is_child) return RunToTheEnd([&] { return again(run, pace); });
  }
  if (WasStoppedAtOnce(end) && shared_page->run[0] != '\0') SayWhatIsKept(shared_page->run);
  return StatusOf(end);
}

void TellGuard(const std::filesystem::path& run) {
  if (shared_page == nullptr) return;
  const std::string text = std::filesystem::absolute(run).string();
  if (text.size() < sizeof shared_page->run) {
    std::memcpy(shared_page->run, text.c_str(), text.size() + 1);
  }
}

bool IsGuarded() { return shared_page != nullptr; }

int StartAgain() {
  shared_page->intent = Intent::kStartAgain;
  return kFailed;
}

}  // namespace runtime
