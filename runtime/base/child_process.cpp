#include "runtime/base/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>

#include "runtime/base/pipe.h"
#include "runtime/base/program_starter.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void Fail(const char* what) {
  throw UserError(fmt::format("cannot {}: {}", what, std::strerror(errno)));
}

// In the child, where only calls are allowed that a signal's handler may make. `pipe`: for what is
// captured.
void ConnectOutput(Captured captured, int pipe) {
  switch (captured) {
    case Captured::kOutputOnly:
      dup2(open("/dev/null", O_WRONLY | O_CLOEXEC), STDERR_FILENO);
      [[fallthrough]];
    case Captured::kOutput:
      dup2(pipe, STDOUT_FILENO);
      return;
    case Captured::kMessages:
      dup2(pipe, STDERR_FILENO);
      [[fallthrough]];
    case Captured::kNothing:
      dup2(STDERR_FILENO, STDOUT_FILENO);
  }
}

[[noreturn]] void BecomeProgram(char** arguments, Captured captured, int pipe, int failure) {
  ConnectOutput(captured, pipe);
  execvp(arguments[0], arguments);
  const int reason = errno;
  [[maybe_unused]] const ssize_t ignored = write(failure, &reason, sizeof reason);
  _exit(127);
}

// A child that is running, in a process group of its own, and that is killed with this object.
class Child {
 public:
  Child(char** arguments, Captured captured, int pipe) {
    Pipe failure;
    const pid_t parent = getpid();
    process_ = fork();
    if (process_ < 0) Fail("start a process");
    if (process_ == 0) {
      setpgid(0, 0);
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (getppid() != parent) _exit(127);
      BecomeProgram(arguments, captured, pipe, failure.input());
    }
    setpgid(process_, process_);  // whoever comes first
    failure.CloseInput();
    int reason = 0;
    while (read(failure.output(), &reason, sizeof reason) < 0 && errno == EINTR) {
    }
    error_ = {reason, std::generic_category()};
    descriptor_ = static_cast<int>(syscall(SYS_pidfd_open, process_, 0));
    if (descriptor_ < 0) {
      const int no_descriptor = errno;
      WaitForEnd();
      errno = no_descriptor;
      Fail("watch a process");
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    WaitForEnd();
    close(descriptor_);
  }

  std::error_code error() const { return error_; }
  int descriptor() const { return descriptor_; }  // readable once it has ended
  // With all that it has started and that is still there. Any thread, before WaitForEnd(): until
  // then nobody else can get its number.
  void Kill() const { kill(-process_, SIGKILL); }
  // The status, as waitpid() gives it.
  int WaitForEnd() {
    if (process_ <= 0) return status_;
    Kill();
    while (waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
    }
    process_ = 0;
    return status_;
  }

 private:
  pid_t process_ = 0;
  int descriptor_ = -1;
  int status_ = 0;
  std::error_code error_;
};

// The same of a process in the sandbox, which starts nothing itself.
class ChildOutside {
 public:
  ChildOutside(const std::vector<std::string>& words, Captured captured, int pipe)
      : nowhere_(captured == Captured::kOutputOnly ? open("/dev/null", O_WRONLY | O_CLOEXEC) : -1),
        program_(words, StreamsOf(captured, pipe, nowhere_)) {}
  ChildOutside(const ChildOutside&) = delete;
  ChildOutside& operator=(const ChildOutside&) = delete;
  ~ChildOutside() {
    if (nowhere_ >= 0) close(nowhere_);
  }

  int descriptor() const { return program_.descriptor(); }
  void Kill() const { program_.Kill(); }
  ProgramEnd WaitForEnd() const { return program_.WaitForEnd(); }

 private:
  static Streams StreamsOf(Captured captured, int pipe, int nowhere) {
    switch (captured) {
      case Captured::kOutputOnly:
        return {STDIN_FILENO, pipe, nowhere};
      case Captured::kOutput:
        return {STDIN_FILENO, pipe, STDERR_FILENO};
      case Captured::kMessages:
        return {STDIN_FILENO, pipe, pipe};
      case Captured::kNothing:
        break;
    }
    return {STDIN_FILENO, STDERR_FILENO, STDERR_FILENO};
  }

  int nowhere_;
  OutsideProgram program_;
};

// What is there to read; false at the end.
bool ReadSome(int pipe, std::string& text) {
  char piece[4096];
  for (ssize_t size; (size = read(pipe, piece, sizeof piece)) != 0;) {
    if (size > 0) text.append(piece, static_cast<size_t>(size));
    if (size < 0 && errno != EINTR) return errno == EAGAIN;
  }
  return false;
}

int MillisecondsUntil(Clock::time_point end) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
  return static_cast<int>(std::clamp<int64_t>(left, 0, INT_MAX));
}

// Until the child has ended, not until its output has: others may have that open as well. Returns
// whether it was killed because it took too long.
template <class AnyChild>
bool Await(const AnyChild& child, int pipe, Clock::time_point end, std::string& text) {
  fcntl(pipe, F_SETFL, O_NONBLOCK);
  pollfd descriptors[] = {{child.descriptor(), POLLIN, 0}, {pipe, POLLIN, 0}};
  bool was_too_slow = false;
  while (descriptors[0].revents == 0) {
    const int ready = poll(descriptors, 2, was_too_slow ? -1 : MillisecondsUntil(end));
    if (ready < 0) {
      for (pollfd& descriptor : descriptors) descriptor.revents = 0;
    } else if (ready == 0) {
      was_too_slow = true;
      child.Kill();
    } else if (descriptors[1].revents != 0 && !ReadSome(pipe, text)) {
      descriptors[1].fd = -1;
    }
  }
  ReadSome(pipe, text);
  return was_too_slow;
}

}  // namespace

namespace {

template <class AnyChild>
void AwaitWithin(const AnyChild& child, int pipe, const ChildLimits& limits, ChildResult& result) {
  const std::stop_callback kill_it(limits.stop, [&child] { child.Kill(); });
  result.was_too_slow = Await(child, pipe, Clock::now() + limits.patience, result.captured);
}

bool IsSuccess(int status) { return WIFEXITED(status) && WEXITSTATUS(status) == 0; }

ChildResult RunOutside(const std::vector<std::string>& words, Captured captured,
                       const ChildLimits& limits) {
  Pipe output;
  const ChildOutside child(words, captured, output.input());
  output.CloseInput();
  ChildResult result;
  AwaitWithin(child, output.output(), limits, result);
  const ProgramEnd end = child.WaitForEnd();
  result.error = {end.error, std::generic_category()};
  result.is_success = end.error == 0 && IsSuccess(end.status);
  return result;
}

}  // namespace

ChildResult RunChild(std::vector<std::string> words, Captured captured, const ChildLimits& limits) {
  if (AreProgramsStartedOutside()) return RunOutside(words, captured, limits);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  Pipe output;
  Child child(arguments.data(), captured, output.input());
  output.CloseInput();
  ChildResult result;
  result.error = child.error();
  if (result.error) return result;
  AwaitWithin(child, output.output(), limits, result);
  result.is_success = IsSuccess(child.WaitForEnd());
  return result;
}

}  // namespace runtime
