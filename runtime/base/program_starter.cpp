#include "runtime/base/program_starter.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>
#include <string_view>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

constexpr size_t kLongestRequest = 1 << 16;  // bytes
constexpr size_t kDescriptors = 4;           // the three streams, and the control socket

// The first word of errands for no program: the file at the second word goes to the output.
constexpr const char* kReadPlugin = "read-plugin";
constexpr const char* kReadTable = "read-table";

int starter = -1;  // the socket to it; in that process itself: -1

struct Errand {
  std::vector<std::string> words;
  std::array<int, kDescriptors> descriptors{-1, -1, -1, -1};

  Streams streams() const { return {descriptors[0], descriptors[1], descriptors[2]}; }
  int control() const { return descriptors[3]; }
};

// A message with room for the descriptors of an errand.
struct Packet {
  explicit Packet(void* bytes, size_t size) : part{bytes, size} {
    header.msg_iov = &part;
    header.msg_iovlen = 1;
    header.msg_control = room.data();
    header.msg_controllen = room.size();
  }
  Packet(const Packet&) = delete;
  Packet& operator=(const Packet&) = delete;

  iovec part;
  alignas(cmsghdr) std::array<char, CMSG_SPACE(kDescriptors * sizeof(int))> room{};
  msghdr header{};
};

// Each word ends with a zero.
std::vector<std::string> SplitWords(std::string_view text) {
  std::vector<std::string> words;
  while (!text.empty()) {
    const size_t end = std::min(text.find('\0'), text.size());
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(text.size(), end + 1));
  }
  return words;
}

// Nothing at the end of the socket.
std::optional<Errand> ReceiveErrand(int socket) {
  std::string bytes(kLongestRequest, '\0');
  Packet packet(bytes.data(), bytes.size());
  ssize_t size = 0;
  do {
    size = recvmsg(socket, &packet.header, MSG_CMSG_CLOEXEC);
  } while (size < 0 && errno == EINTR);
  if (size <= 0) return std::nullopt;
  Errand errand;
  errand.words = SplitWords(std::string_view(bytes).substr(0, static_cast<size_t>(size)));
  const cmsghdr* attached = CMSG_FIRSTHDR(&packet.header);
  if (attached != nullptr && attached->cmsg_type == SCM_RIGHTS) {
    const size_t length = std::min(attached->cmsg_len - CMSG_LEN(0), kDescriptors * sizeof(int));
    std::memcpy(errand.descriptors.data(), CMSG_DATA(attached), length);
  }
  return errand;
}

void Close(const Errand& errand) {
  for (const int descriptor : errand.descriptors) {
    if (descriptor >= 0) close(descriptor);
  }
}

// Returns 0, or an errno.
int CopyAll(int file, int output) {
  char piece[65536];
  ssize_t size = 0;
  while ((size = read(file, piece, sizeof piece)) > 0) {
    for (ssize_t done = 0, count = 0; done < size; done += count) {
      count = write(output, piece + done, static_cast<size_t>(size - done));
      if (count <= 0) return errno;
    }
  }
  return size < 0 ? errno : 0;
}

bool IsPlugin(int file) {
  constexpr std::string_view kElf = "\177ELF";
  char begin[kElf.size()];
  return pread(file, begin, sizeof begin, 0) == sizeof begin &&
         std::string_view(begin, sizeof begin) == kElf;
}

// By the name that the file itself has, whatever link has led to it.
bool IsTable(int file) {
  std::error_code error;
  const auto name = std::filesystem::read_symlink(fmt::format("/proc/self/fd/{}", file), error);
  return name.extension() == ".csv";
}

// Returns 0, or an errno. Whoever asks could read any file of ours if it were not looked at what it
// is.
int DoReading(const Errand& errand) {
  const int file = open(errand.words[1].c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return errno;
  struct stat status {};
  if (fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) return EINVAL;
  const bool is_plugin = errand.words[0] == kReadPlugin;
  if (is_plugin && !IsPlugin(file)) return ENOEXEC;
  if (!is_plugin && !IsTable(file)) return EACCES;
  return CopyAll(file, errand.descriptors[1]);
}

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
    end.error = DoReading(errand);
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
    Close(*errand);
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
  std::string bytes;
  for (const std::string& word : words) bytes.append(word).push_back('\0');
  int control[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, control) != 0) FailTo("make a socket");
  control_ = control[0];
  const std::array<int, kDescriptors> descriptors = {streams.input, streams.output, streams.errors,
                                                     control[1]};
  Packet packet(bytes.data(), bytes.size());
  cmsghdr* attached = CMSG_FIRSTHDR(&packet.header);
  attached->cmsg_level = SOL_SOCKET;
  attached->cmsg_type = SCM_RIGHTS;
  attached->cmsg_len = CMSG_LEN(sizeof descriptors);
  std::memcpy(CMSG_DATA(attached), descriptors.data(), sizeof descriptors);
  const bool is_sent =
      bytes.size() <= kLongestRequest && sendmsg(starter, &packet.header, MSG_NOSIGNAL) >= 0;
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
