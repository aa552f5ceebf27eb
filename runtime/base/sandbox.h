// What a process gives up before it runs code of others: files outside its folders, the network,
// other programs. docs/reliability.md says what is refused then.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/base/landlock.h"

namespace runtime {

// Whether processes are to enter it: unless --no-sandbox was given to this process or to one that
// has started it.
bool IsSandboxWanted();
// For this process and those that it starts.
void DoWithoutSandbox();

// Warns, once for this process and those that it starts, on the standard error stream where the
// sandbox is wanted and the kernel lacks a part of it: which one, and what plugins can do then.
void WarnWhereSandboxIsWeak();

struct SandboxRules {
  FileRules files;           // besides those of the system and of the programs themselves
  bool may_connect = false;  // to Unix sockets on which other programs listen
};

// Irrevocable; to be called before this process has other threads. Does nothing where it is not
// wanted. Throws UserError where the kernel has such parts and refuses them.
void EnterSandbox(const SandboxRules& rules);

// In the sandbox: takes away what files `rules` do not have.
void RestrictFilesMore(const FileRules& rules);

}  // namespace runtime
