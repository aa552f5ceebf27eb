// seccomp: which system calls this process, and all that it starts, can make.
#pragma once

namespace runtime {

// Whether the kernel has it, and this knows the processor's system calls.
bool HasSystemCallFilter();

// From now on it is refused, with EPERM, to execute a program, to make a socket that is no Unix
// stream, to change the mode or owner of a file by its name, to trace or signal another process,
// and to put characters into a terminal's input; without `may_connect` also to connect to anything.
// A socket that is open already stays so, and goes on listening.
//
// Needs PR_SET_NO_NEW_PRIVS; is of all threads of this process. Throws UserError where the kernel
// refuses, and does nothing where there is no filter.
void RestrictSystemCalls(bool may_connect);

}  // namespace runtime
