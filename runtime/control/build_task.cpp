#include "runtime/control/build_task.h"

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

// What of a child's output is for us.
enum class Captured { kNothing, kOutput, kMessages };

// Where a child process writes to. Standard output that is not captured goes where its standard
// error goes: ours may be read by a program.
class ChildOutput {
 public:
  explicit ChildOutput(Captured captured) {
    if (captured != Captured::kNothing && pipe2(ends_, O_CLOEXEC) != 0) {
      throw UserError(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
    }
    posix_spawn_file_actions_init(&actions_);
    if (captured == Captured::kOutput) {
      posix_spawn_file_actions_adddup2(&actions_, ends_[1], STDOUT_FILENO);
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

// Runs `taskc` with these words. What is captured goes to `text`.
bool Run(std::vector<std::string> words, Captured captured, std::string* text) {
  const std::filesystem::path compiler = CompilerProgram();
  words.insert(words.begin(), compiler.string());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ChildOutput output(captured);
  pid_t child = 0;
  const int error =
      posix_spawn(&child, compiler.c_str(), output.actions(), nullptr, arguments.data(), environ);
  if (error != 0) {
    throw UserError(fmt::format(
        "{}: cannot run the compiler: {}; install taskc beside the trainer, or give a plugin that "
        "is built already",
        compiler.string(), std::strerror(error)));
  }
  if (captured != Captured::kNothing) *text = output.Read();
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

std::filesystem::path CompilerProgram() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "taskc";
}

bool RunCompiler(const std::vector<std::string>& words, std::string& output) {
  return Run(words, Captured::kOutput, &output);
}

bool BuildTask(const std::filesystem::path& task, const std::filesystem::path& plugin,
               std::string* messages) {
  return Run({"build", task.string(), "-o", plugin.string()},
             messages != nullptr ? Captured::kMessages : Captured::kNothing, messages);
}

}  // namespace runtime
