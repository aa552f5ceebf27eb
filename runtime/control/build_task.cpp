#include "runtime/control/build_task.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "runtime/module/user_error.h"

namespace runtime {
namespace {

// Where a child process writes to. Its standard output goes where its standard error goes: ours may
// be read by a program.
class ChildOutput {
 public:
  explicit ChildOutput(bool is_captured) {
    if (is_captured && pipe2(ends_, O_CLOEXEC) != 0) {
      throw UserError(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
    }
    posix_spawn_file_actions_init(&actions_);
    if (is_captured) posix_spawn_file_actions_adddup2(&actions_, ends_[1], STDERR_FILENO);
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

}  // namespace

std::filesystem::path CompilerProgram() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "taskc";
}

bool BuildTask(const std::filesystem::path& task, const std::filesystem::path& plugin,
               std::string* messages) {
  const std::filesystem::path compiler = CompilerProgram();
  std::array<std::string, 5> words = {compiler.string(), "build", task.string(), "-o",
                                      plugin.string()};
  std::array<char*, words.size() + 1> arguments{};
  for (size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  ChildOutput output(messages != nullptr);
  pid_t child = 0;
  const int error =
      posix_spawn(&child, compiler.c_str(), output.actions(), nullptr, arguments.data(), environ);
  if (error != 0) {
    throw UserError(fmt::format(
        "{}: cannot run the compiler: {}; install taskc beside the trainer, or give a plugin that "
        "is built already",
        compiler.string(), std::strerror(error)));
  }
  if (messages != nullptr) *messages = output.Read();
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace runtime
