#include "tests/runtime/trainer/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace runtime {
namespace {

// Some of what is waited for takes 10 s of CPU, on a machine that may do other work as well.
constexpr std::chrono::seconds kPatience{120};

std::string Contents(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

}  // namespace

ChildProcess::ChildProcess(std::vector<std::string> words) {
  std::string name = (std::filesystem::temp_directory_path() / "trainer-child-XXXXXX").string();
  folder_ = mkdtemp(name.data());
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, (folder_ / "out").c_str(), flags, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, (folder_ / "err").c_str(), flags, 0600);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int error =
      posix_spawn(&process_, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::runtime_error("cannot start " + words[0]);
}

ChildProcess::~ChildProcess() {
  if (!HasEnded()) {
    Send(SIGKILL);
    Wait();
  }
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

bool ChildProcess::HasEnded() {
  if (!has_ended_) has_ended_ = waitpid(process_, &wait_status_, WNOHANG) == process_;
  return has_ended_;
}

template <class Condition>
bool ChildProcess::WaitFor(const Condition& condition) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (!HasEnded() && std::chrono::steady_clock::now() < deadline) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

bool ChildProcess::WaitForLines(int lines) {
  return WaitFor([&] { return std::ranges::count(Contents(folder_ / "out"), '\n') >= lines; });
}

bool ChildProcess::WaitForError(const std::string& text) {
  return WaitFor([&] { return Contents(folder_ / "err").find(text) != std::string::npos; });
}

void ChildProcess::Send(int signal) { kill(process_, signal); }

ProgramResult ChildProcess::Wait() {
  if (!has_ended_) has_ended_ = waitpid(process_, &wait_status_, 0) == process_;
  ProgramResult result;
  result.exit_status = WIFEXITED(wait_status_) ? WEXITSTATUS(wait_status_) : -1;
  result.signal = WIFSIGNALED(wait_status_) ? WTERMSIG(wait_status_) : 0;
  result.output = Contents(folder_ / "out");
  result.errors = Contents(folder_ / "err");
  return result;
}

ProgramResult RunProgram(std::vector<std::string> words) {
  return ChildProcess(std::move(words)).Wait();
}

}  // namespace runtime
