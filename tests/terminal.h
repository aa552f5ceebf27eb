// Programs on a terminal of their own.
#pragma once

#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

// Whether this machine has pseudo terminals; a bare chroot has none.
inline bool HasTerminals() { return std::filesystem::exists("/dev/pts/ptmx"); }

// A program that runs on a terminal where a person types and changes the size of the window.
class TerminalProgram {
 public:
  // words[0] is the program's file.
  TerminalProgram(const std::vector<std::string>& words, unsigned short columns = 80,
                  unsigned short rows = 24) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    winsize size{rows, columns, 0, 0};
    child_ = forkpty(&terminal_, nullptr, nullptr, &size);
    if (child_ != 0) return;
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  TerminalProgram(const TerminalProgram&) = delete;
  TerminalProgram& operator=(const TerminalProgram&) = delete;
  ~TerminalProgram() {
    close(terminal_);  // hangs up on a program that still runs
    if (child_ > 0) Reap();
  }

  void Type(const std::string& keys) {
    if (write(terminal_, keys.data(), keys.size()) == static_cast<ssize_t>(keys.size())) return;
    printed_ += "(the terminal does not take what is typed)\n";
  }
  void Resize(unsigned short columns, unsigned short rows = 24) {
    const winsize size{rows, columns, 0, 0};
    ioctl(terminal_, TIOCSWINSZ, &size);
  }
  // Reads on until the program has printed this `count` times; false where it ends before.
  bool WaitFor(const std::string& text, int count = 1) {
    while (CountOf(text) < count) {
      if (!Read()) return false;
    }
    return true;
  }
  // Reads to the end; the status as waitpid() gives it.
  int Wait() {
    while (Read()) {
    }
    return Reap();
  }
  const std::string& printed() const { return printed_; }

 private:
  int CountOf(const std::string& text) const {
    int count = 0;
    for (size_t at = 0; (at = printed_.find(text, at)) != std::string::npos; at += text.size()) {
      ++count;
    }
    return count;
  }
  bool Read() {
    char bytes[4096];
    const ssize_t size = read(terminal_, bytes, sizeof bytes);
    if (size > 0) printed_.append(bytes, static_cast<size_t>(size));
    return size > 0;
  }
  int Reap() {
    int status = 0;
    waitpid(std::exchange(child_, 0), &status, 0);
    return status;
  }

  int terminal_ = -1;
  pid_t child_ = 0;
  std::string printed_;
};

// What the program prints where a person types `typed`.
inline std::string PrintedOnTerminal(const std::vector<std::string>& words,
                                     const std::string& typed = "") {
  TerminalProgram program(words);
  program.Type(typed);
  program.Wait();
  return program.printed();
}
