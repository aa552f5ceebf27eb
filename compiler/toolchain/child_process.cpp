#include "compiler/toolchain/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string_view>

#include "compiler/source/diagnostic.h"

namespace compiler {
namespace {

// Owns what posix_spawn needs to know of the child's files.
class FileActions {
 public:
  explicit FileActions(const ChildProcess& child) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, child.input.c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, child.output.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0666);
    posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
  }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;

  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

// Ours, but for the language of messages and the place of temporary files.
std::vector<std::string> ChildEnvironment(const std::filesystem::path& scratch) {
  std::vector<std::string> environment;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    std::string_view text = *variable;
    if (!text.starts_with("LC_ALL=") && !text.starts_with("TMPDIR=")) {
      environment.emplace_back(text);
    }
  }
  environment.emplace_back("LC_ALL=C");
  environment.push_back("TMPDIR=" + scratch.string());
  return environment;
}

std::vector<char*> Pointers(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

int Run(const ChildProcess& child) {
  std::vector<std::string> command = child.command;
  std::vector<std::string> environment = ChildEnvironment(child.scratch);
  FileActions actions(child);
  pid_t process = 0;
  // posix_spawn, because a fork copies the page tables of a program that may be large.
  int reason = posix_spawn(&process, command.front().c_str(), actions.get(), nullptr,
                           Pointers(command).data(), Pointers(environment).data());
  if (reason != 0) {
    throw CallError(fmt::format("cannot run {}: {}", command.front(), std::strerror(reason)));
  }
  int status = 0;
  while (waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) {
      throw CallError(fmt::format("cannot wait for {}: {}", command.front(), std::strerror(errno)));
    }
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace compiler
