// Programs as a user starts them: arguments in, exit status and what they print out.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace runtime {

struct ProgramResult {
  int exit_status = 0;  // -1 if a signal ended it
  int signal = 0;       // that ended it, or 0
  std::string output;
  std::string errors;
};

class ChildProcess {
 public:
  // Starts the program; what it prints goes to files in a temporary folder.
  explicit ChildProcess(std::vector<std::string> words);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();  // kills it if it still runs

  // Waits until it has printed this many lines, or this text on standard error; false if it ended
  // before, or after two minutes.
  bool WaitForLines(int lines);
  bool WaitForError(const std::string& text);
  void Send(int signal);
  pid_t process() const { return process_; }
  ProgramResult Wait();

 private:
  template <class Condition>
  bool WaitFor(const Condition& condition);
  bool HasEnded();

  std::filesystem::path folder_;
  pid_t process_ = 0;
  bool has_ended_ = false;
  int wait_status_ = 0;
};

ProgramResult RunProgram(std::vector<std::string> words);

}  // namespace runtime
