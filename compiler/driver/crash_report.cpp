#include "compiler/driver/crash_report.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <deque>

#include "compiler/driver/exit_status.h"

namespace compiler {
namespace {

// A file to copy, and its name inside the folder.
struct Remembered {
  std::string file;
  std::string name;
};

// Everything is put together before a crash: a signal's handler may not allocate.
struct State {
  std::string folder;
  std::string heading;  // version and command line
  std::string farewell;
  std::deque<Remembered> files;
};
State& TheState() {
  static State state;
  return state;
}

// ---- Only calls that a signal's handler may make ------------------------------------------------

void Write(int file, const char* bytes, size_t size) {
  while (size > 0) {
    const ssize_t written = write(file, bytes, size);
    if (written <= 0) return;
    bytes += written;
    size -= static_cast<size_t>(written);
  }
}

int Create(int folder, const char* name) {
  return openat(folder, name, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
}

void Copy(const char* from, int folder, const char* name) {
  const int in = open(from, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (in < 0) return;
  struct stat status {};
  if (fstat(in, &status) == 0 && S_ISREG(status.st_mode)) {
    const int out = Create(folder, name);
    char bytes[4096];
    for (ssize_t size; (size = read(in, bytes, sizeof bytes)) > 0;) {
      Write(out, bytes, static_cast<size_t>(size));
    }
    close(out);
  }
  close(in);
}

void WriteInto(const char* path, const char* message) {
  mkdir(path, 0755);
  const int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  const State& state = TheState();
  const int report = Create(folder, "report.txt");
  Write(report, state.heading.data(), state.heading.size());
  Write(report, message, std::strlen(message));
  Write(report, "\n", 1);
  close(report);
  for (const Remembered& file : state.files) Copy(file.file.c_str(), folder, file.name.c_str());
  close(folder);
}

void OnCrash(int signal) {
  char message[] = "crash: signal   ";
  message[sizeof message - 3] = static_cast<char>('0' + signal / 10);
  message[sizeof message - 2] = static_cast<char>('0' + signal % 10);
  WriteInto(TheState().folder.c_str(), message);
  Write(STDERR_FILENO, TheState().farewell.data(), TheState().farewell.size());
  _exit(static_cast<int>(ExitStatus::kInternalError));
}

// ---- Before a crash -----------------------------------------------------------------------------

void CatchSignals() {
  // Its own stack, for the case that the program's is used up.
  static std::array<char, 65536> stack;
  stack_t alternative{};
  alternative.ss_sp = stack.data();
  alternative.ss_size = stack.size();
  sigaltstack(&alternative, nullptr);
  struct sigaction action {};
  action.sa_handler = OnCrash;
  action.sa_flags = static_cast<int>(SA_ONSTACK | SA_RESETHAND);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    sigaction(signal, &action, nullptr);
  }
}

}  // namespace

void ReportCrashes(int argc, char** argv) {
  State& state = TheState();
  state.folder = CrashFolder();
  state.heading = "taskc " TASKC_VERSION "\n";
  for (int i = 0; i < argc; ++i) state.heading += fmt::format("{}{}", i > 0 ? " " : "", argv[i]);
  state.heading += "\n";
  state.farewell = fmt::format(
      "taskc: internal error: crash; please report this with the folder {}\n", state.folder);
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]).ends_with(".task")) RememberFile(argv[i]);
  }
  CatchSignals();
}

void RememberFile(const std::filesystem::path& file) {
  std::deque<Remembered>& files = TheState().files;
  if (std::ranges::find(files, file.string(), &Remembered::file) != files.end()) return;
  std::string name = file.filename();
  for (int i = 2; std::ranges::find(files, name, &Remembered::name) != files.end(); ++i) {
    name = fmt::format("{}-{}", i, file.filename().string());
  }
  files.push_back({file, name});
}

void WriteCrashReport(const std::filesystem::path& folder, const std::string& message) {
  WriteInto(folder.c_str(), message.c_str());
}

std::filesystem::path CrashFolder() {
  std::error_code error;
  std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (error) folder = ".";
  return folder / fmt::format("taskc-report-{}", getpid());
}

}  // namespace compiler
