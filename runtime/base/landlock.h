// Landlock, by its system calls: which files this process, and all that it starts, can reach.
#pragma once

#include <filesystem>
#include <vector>

namespace runtime {

struct FileRules {
  std::vector<std::filesystem::path> readable;  // files, and folders with all that is in them
  std::vector<std::filesystem::path> writable;  // the same, to read as well
  // Folders in which empty folders can be removed, but nothing else.
  std::vector<std::filesystem::path> tidied = {};
};

// Of the kernel's Landlock; 0: it has none.
int LandlockVersion();

// From now on nothing else can be opened, made, renamed or removed, and no program be executed;
// from version 4 on no TCP port is bound or connected to, from 6 on no process outside gets a
// signal. What is open already stays open. A second call only takes away. Paths that do not exist
// are left out. Needs PR_SET_NO_NEW_PRIVS; is of this thread and those that it starts. Throws
// UserError where the kernel refuses, and does nothing where it has no Landlock.
void RestrictFiles(const FileRules& rules);

}  // namespace runtime
