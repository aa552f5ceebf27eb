#include "runtime/live/workers/worker.h"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "runtime/base/pipe.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

constexpr int kCannotStart = 127;

}  // namespace

void LineReader::Read(const std::function<void(std::string_view)>& line) {
  char buffer[4096];
  const ssize_t size = read(descriptor_, buffer, sizeof buffer);
  if (size < 0 && errno == EINTR) return;
  if (size <= 0) {
    if (!rest_.empty()) line(rest_);
    return Close();
  }
  rest_.append(buffer, static_cast<size_t>(size));
  size_t begin = 0;
  for (size_t end; (end = rest_.find('\n', begin)) != std::string::npos; begin = end + 1) {
    line(std::string_view(rest_).substr(begin, end - begin));
  }
  rest_.erase(0, begin);
}

void LineReader::Close() {
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = -1;
}

struct Worker::Pipes {
  Pipe output;
  Pipe errors;
};

Worker::Worker(const std::vector<std::string>& words) : Worker(words, Pipes()) {}

Worker::Worker(const std::vector<std::string>& words, Pipes pipes)
    : output_(pipes.output.TakeOutput()), errors_(pipes.errors.TakeOutput()) {
  std::string program = "trainer";
  std::vector<char*> arguments = {program.data()};
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) {
    // Ctrl-C reaches the supervisor alone, which then asks its workers to stop, once.
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(kCannotStart);
    dup2(pipes.output.input(), STDOUT_FILENO);
    dup2(pipes.errors.input(), STDERR_FILENO);
    execv("/proc/self/exe", arguments.data());
    _exit(kCannotStart);
  }
  if (process_ < 0) throw UserError(fmt::format("cannot start a worker: {}", std::strerror(errno)));
}

Worker::~Worker() {
  if (process_ <= 0) return;
  kill(process_, SIGKILL);
  WaitStatus();
}

void Worker::Send(int signal) const {
  if (process_ > 0) kill(process_, signal);
}

int Worker::WaitStatus() {
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = 0;
  return status;
}

}  // namespace runtime
