#include "runtime/base/piped_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "runtime/base/pipe.h"
#include "runtime/base/user_error.h"

extern char** environ;

namespace runtime {
namespace {

// What the child does before it becomes the program, and what it is like then.
class Preparation {
 public:
  Preparation(int input, int output) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawnattr_init(&attributes_);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes_, &none);  // this thread may have blocked all
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  }
  Preparation(const Preparation&) = delete;
  Preparation& operator=(const Preparation&) = delete;
  ~Preparation() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }

  int Start(std::vector<std::string>& words, pid_t& process) const {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    return posix_spawn(&process, arguments[0], &actions_, &attributes_, arguments.data(), environ);
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

}  // namespace

PipedProgram::PipedProgram(std::vector<std::string> words) {
  Pipe input;
  Pipe output;
  if (AreProgramsStartedOutside()) {
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    outside_ =
        std::make_unique<OutsideProgram>(words, Streams{input.output(), output.input(), nowhere});
    close(nowhere);
  } else {
    Start(words, input.output(), output.input());
  }
  input_ = input.TakeInput();
  output_ = output.TakeOutput();
}

void PipedProgram::Start(std::vector<std::string>& words, int input, int output) {
  const int error = Preparation(input, output).Start(words, process_);
  if (error != 0) {
    throw UserError(fmt::format("{}: cannot be started: {}", words[0], std::strerror(error)));
  }
}

PipedProgram::~PipedProgram() {
  if (input_ >= 0) close(input_);
  if (output_ >= 0) close(output_);
  if (process_ <= 0) return;
  kill(-process_, SIGKILL);
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

int PipedProgram::TakeInput() { return std::exchange(input_, -1); }

int PipedProgram::TakeOutput() { return std::exchange(output_, -1); }

}  // namespace runtime
