#include "runtime/base/file_remover.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

// Waits for the end of the pipe, and so for that of the process which holds its input. Nothing
// else is kept open: who reads the program's output waits for all of it to be closed.
[[noreturn]] void RemoveAtEnd(int pipe, const std::filesystem::path& file) {
  for (const int ignored : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) std::signal(ignored, SIG_IGN);
  dup2(pipe, STDIN_FILENO);
  close_range(STDIN_FILENO + 1, ~0U, 0);
  char byte = 0;
  while (read(STDIN_FILENO, &byte, 1) < 0 && errno == EINTR) {
  }
  unlink(file.c_str());
  _exit(0);
}

}  // namespace

FileRemover::FileRemover(const std::filesystem::path& file) {
  process_ = fork();
  if (process_ == 0) RemoveAtEnd(pipe_.output(), file);
  const int reason = errno;
  pipe_.CloseOutput();
  if (process_ < 0) {
    throw UserError(fmt::format("cannot start a process: {}", std::strerror(reason)));
  }
}

FileRemover::~FileRemover() {
  pipe_.CloseInput();
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace runtime
