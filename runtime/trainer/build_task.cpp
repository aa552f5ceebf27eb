#include "runtime/trainer/build_task.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>

#include "runtime/module/user_error.h"

namespace runtime {
namespace {

// Our standard output may be read by a program: what the compiler prints goes to standard error.
class OutputToError {
 public:
  OutputToError() {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, STDERR_FILENO, STDOUT_FILENO);
  }
  OutputToError(const OutputToError&) = delete;
  OutputToError& operator=(const OutputToError&) = delete;
  ~OutputToError() { posix_spawn_file_actions_destroy(&actions_); }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

}  // namespace

bool BuildTask(const std::filesystem::path& task, const std::filesystem::path& plugin) {
  const std::filesystem::path compiler =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "taskc";
  std::array<std::string, 5> words = {compiler.string(), "build", task.string(), "-o",
                                      plugin.string()};
  std::array<char*, words.size() + 1> arguments{};
  for (size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  const OutputToError output_to_error;
  pid_t child = 0;
  const int error = posix_spawn(&child, compiler.c_str(), output_to_error.get(), nullptr,
                                arguments.data(), environ);
  if (error != 0) {
    throw UserError(fmt::format(
        "{}: cannot run the compiler: {}; install taskc beside the trainer, or give a plugin that "
        "is built already",
        compiler.string(), std::strerror(error)));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace runtime
