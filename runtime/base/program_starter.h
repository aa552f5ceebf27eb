// A process outside of the sandbox that starts the few programs which those inside need.
//
// Its client is not trusted: a plugin in the same process can ask as well. Hence it starts nothing
// that MayStart does not allow, word for word.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/file/read.h"

namespace runtime {

// Whether a program with these words may be started.
using MayStart = bool (*)(const std::vector<std::string>& words);

// The descriptors that a program gets as its own three.
struct Streams {
  int input;
  int output;
  int errors;
};

// From now on this process starts its programs by way of a new one, which ends with it. To be
// called before there are other threads, once. Throws UserError where the system has no process
// left.
void StartProgramsOutside(MayStart may_start);
bool AreProgramsStartedOutside();

// What became of a program.
struct ProgramEnd {
  int error = 0;   // why it could not be started, an errno; EPERM: it may not be
  int status = 0;  // as waitpid() gives it
};

// One that was asked for outside. It is killed with this object, with all that it has started. Any
// thread.
class OutsideProgram {
 public:
  // Throws UserError where it cannot be asked for.
  OutsideProgram(const std::vector<std::string>& words, const Streams& streams);
  OutsideProgram(const OutsideProgram&) = delete;
  OutsideProgram& operator=(const OutsideProgram&) = delete;
  ~OutsideProgram();

  int descriptor() const { return control_; }  // readable once it has ended
  void Kill() const;                           // any thread
  ProgramEnd WaitForEnd() const;

 private:
  int control_ = -1;
};

// Copies a plugin that lies outside of the sandbox to `copy`; what is no ELF file becomes an empty
// one. Throws UserError where it cannot be read, or written.
void CopyPluginFromOutside(const std::filesystem::path& plugin, const std::filesystem::path& copy);

// As file::Read(), also of a file outside of the sandbox if it is called `.csv`.
file::Reading ReadTable(const std::filesystem::path& table, size_t limit);

}  // namespace runtime
