#include "runtime/control/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "runtime/module/user_error.h"

namespace runtime {
namespace {

// Where a child process writes to.
class ChildOutput {
 public:
  explicit ChildOutput(Captured captured) {
    if (captured != Captured::kNothing && pipe2(ends_, O_CLOEXEC) != 0) {
      throw UserError(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
    }
    posix_spawn_file_actions_init(&actions_);
    if (captured == Captured::kOutput || captured == Captured::kOutputOnly) {
      posix_spawn_file_actions_adddup2(&actions_, ends_[1], STDOUT_FILENO);
      if (captured == Captured::kOutputOnly) {
        posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
      }
      return;
    }
    if (captured == Captured::kMessages) {
      posix_spawn_file_actions_adddup2(&actions_, ends_[1], STDERR_FILENO);
    }
    posix_spawn_file_actions_adddup2(&actions_, STDERR_FILENO, STDOUT_FILENO);
  }
  ChildOutput(const ChildOutput&) = delete;
  ChildOutput& operator=(const ChildOutput&) = delete;
  ~ChildOutput() {
    posix_spawn_file_actions_destroy(&actions_);
    for (const int end : ends_) {
      if (end >= 0) close(end);
    }
  }

  const posix_spawn_file_actions_t* actions() const { return &actions_; }

  // What was captured, until the child and all that it has started have closed it.
  std::string Read() {
    close(ends_[1]);
    ends_[1] = -1;
    std::string text;
    char piece[4096];
    for (ssize_t size; (size = read(ends_[0], piece, sizeof piece)) != 0;) {
      if (size > 0) text.append(piece, static_cast<size_t>(size));
      if (size < 0 && errno != EINTR) break;
    }
    return text;
  }

 private:
  int ends_[2] = {-1, -1};
  posix_spawn_file_actions_t actions_;
};

bool HasSucceeded(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

ChildResult RunChild(std::vector<std::string> words, Captured captured) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ChildOutput output(captured);
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, arguments[0], output.actions(), nullptr, arguments.data(), environ);
  ChildResult result;
  result.error = {error, std::generic_category()};
  if (error != 0) return result;
  if (captured != Captured::kNothing) result.captured = output.Read();
  result.is_success = HasSucceeded(child);
  return result;
}

}  // namespace runtime
