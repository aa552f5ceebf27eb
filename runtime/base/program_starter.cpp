#include "runtime/base/program_starter.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>

#include "runtime/base/errand.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

int starter = -1;  // the socket to it; in that process itself: -1

// Until it has ended, or whoever has asked has gone or killed it.
ProgramEnd RunToEnd(const Errand& errand) {
  std::vector<char*> arguments;
  for (const std::string& word : errand.words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  int failure[2];
  if (pipe2(failure, O_CLOEXEC) != 0) return {errno, 0};
  const pid_t program = fork();
  if (program < 0) return {errno, 0};
  if (program == 0) {
    setpgid(0, 0);
    const Streams streams = errand.streams();
    dup2(streams.input, STDIN_FILENO);
    dup2(streams.output, STDOUT_FILENO);
    dup2(streams.errors, STDERR_FILENO);
    execv(arguments[0], arguments.data());
    const int reason = errno;
    [[maybe_unused]] const ssize_t ignored = write(failure[1], &reason, sizeof reason);
    _exit(127);
  }
  setpgid(program, program);  // whoever comes first
  close(failure[1]);
  for (const int stream : {errand.descriptors[0], errand.descriptors[1], errand.descriptors[2]}) {
    close(stream);
  }
  ProgramEnd end;
  if (read(failure[0], &end.error, sizeof end.error) <= 0) end.error = 0;
  const auto process = static_cast<int>(syscall(SYS_pidfd_open, program, 0));
  pollfd descriptors[] = {{process, POLLIN, 0}, {errand.control(), POLLIN, 0}};
  while (process >= 0 && poll(descriptors, 2, -1) < 0 && errno == EINTR) {
  }
  kill(-program, SIGKILL);
  while (waitpid(program, &end.status, 0) < 0 && errno == EINTR) {
  }
  return end;
}

[[noreturn]] void Do(const Errand& errand, MayStart may_start) {
  signal(SIGCHLD, SIG_DFL);
  signal(SIGPIPE, SIG_IGN);
  ProgramEnd end;
  if (errand.control() < 0 || errand.words.empty()) _exit(1);
  const std::string& what = errand.words[0];
  if (errand.words.size() == 2 && (what == kReadPlugin || what == kReadTable)) {
    end.error = ReadForErrand(errand);
  } else if (may_start(errand.words)) {
    end = RunToEnd(errand);
  } else {
    end.error = EPERM;
  }
  send(errand.control(), &end, sizeof end, MSG_NOSIGNAL);
  _exit(0);
}

// Until the other side has ended.
[[noreturn]] void Serve(int socket, MayStart may_start) {
  setpgid(0, 0);             // Ctrl-C is for those whom we serve, by whose end we end
  signal(SIGCHLD, SIG_IGN);  // nobody waits for those who do the errands
  for (const int signal_number : {SIGINT, SIGTERM, SIGTSTP}) signal(signal_number, SIG_DFL);
  while (const std::optional<Errand> errand = ReceiveErrand(socket)) {
    const pid_t child = fork();
    if (child == 0) {
      close(socket);
      Do(*errand, may_start);
    }
    CloseDescriptors(*errand);
  }
  _exit(0);
}

[[noreturn]] void FailTo(const char* what) {
  throw UserError(fmt::format("cannot {}: {}", what, std::strerror(errno)));
}

}  // namespace

void StartProgramsOutside(MayStart may_start) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) FailTo("make a socket");
  const pid_t child = fork();
  if (child < 0) FailTo("start a process");
  if (child == 0) {
    close(ends[0]);
    Serve(ends[1], may_start);
  }
  close(ends[1]);
  starter = ends[0];
}

bool AreProgramsStartedOutside() { return starter >= 0; }

OutsideProgram::OutsideProgram(const std::vector<std::string>& words, const Streams& streams) {
  int control[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, control) != 0) FailTo("make a socket");
  control_ = control[0];
  const bool is_sent =
      SendErrand(starter, {words, {streams.input, streams.output, streams.errors, control[1]}});
  close(control[1]);
  if (is_sent) return;
  close(control_);
  FailTo("start a process outside of the sandbox");
}

OutsideProgram::~OutsideProgram() {
  Kill();
  WaitForEnd();
  close(control_);
}

void OutsideProgram::Kill() const { shutdown(control_, SHUT_WR); }

ProgramEnd OutsideProgram::WaitForEnd() const {
  ProgramEnd end;
  ssize_t size = 0;
  do {
    size = recv(control_, &end, sizeof end, MSG_PEEK | MSG_WAITALL);
  } while (size < 0 && errno == EINTR);
  if (size == static_cast<ssize_t>(sizeof end)) return end;
  return {.error = ECHILD};  // whoever started it was killed
}

namespace {

// Returns 0, or an errno.
int ReadOutside(const char* errand, const std::filesystem::path& file, int output) {
  const std::string path = std::filesystem::absolute(file).string();
  return OutsideProgram({errand, path}, {output, output, output}).WaitForEnd().error;
}

}  // namespace

void CopyPluginFromOutside(const std::filesystem::path& plugin, const std::filesystem::path& copy) {
  const int output = open(copy.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  const int error = output < 0 ? errno : ReadOutside(kReadPlugin, plugin, output);
  if (output >= 0) close(output);
  if (error == 0 || error == ENOEXEC) return;
  throw UserError(fmt::format("{}: cannot be read: {}", plugin.string(), std::strerror(error)));
}

file::Reading ReadTable(const std::filesystem::path& table, size_t limit) {
  file::Reading reading = file::Read(table, limit);
  if (reading.problem.empty() || !AreProgramsStartedOutside()) return reading;
  const int copy = memfd_create("table", MFD_CLOEXEC);
  if (copy < 0) return reading;
  const int error = ReadOutside(kReadTable, table, copy);
  if (error == 0) reading = file::Read(fmt::format("/proc/self/fd/{}", copy), limit);
  close(copy);
  return reading;
}

}  // namespace runtime
