// Another program that is talked to over pipes while it runs.
#pragma once

#include <sys/types.h>

#include <memory>
#include <string>
#include <vector>

#include "runtime/base/program_starter.h"

namespace runtime {

// It reads what is written to input() and writes what can be read from output(); what it says to
// people goes nowhere. It is killed with this object, with all that it has started; it sees the end
// of its input when this process ends.
class PipedProgram {
 public:
  // `words`: the program's path, then its arguments. Throws UserError where it cannot be started.
  explicit PipedProgram(std::vector<std::string> words);
  PipedProgram(const PipedProgram&) = delete;
  PipedProgram& operator=(const PipedProgram&) = delete;
  ~PipedProgram();

  // Descriptors, which become the caller's; to be asked for once each.
  int TakeInput();
  int TakeOutput();

 private:
  void Start(std::vector<std::string>& words, int input, int output);

  pid_t process_ = -1;
  std::unique_ptr<OutsideProgram> outside_;  // in a sandbox, in the place of a process of our own
  int input_ = -1;
  int output_ = -1;
};

}  // namespace runtime
