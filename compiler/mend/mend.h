// Applies the fixes that come with errors, as far as they make a task better.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "compiler/source/file_reader.h"
#include "compiler/source/source_file.h"

namespace compiler {

// A fix that was applied.
struct Mended {
  std::string file;
  Position place;       // where it stood when it was applied
  std::string code;     // of the error that it mends
  std::string message;  // of that error
  std::string before;   // what stood there; empty: something was inserted
  std::string after;    // what stands there now; empty: something was removed
};

struct Mending {
  std::vector<Mended> mended;                // in the order in which they were applied
  std::map<std::string, std::string> texts;  // of the files that have changed; nothing is written
};

// Applies, over and over until nothing is left to apply, each fix that is the only one of its error
// and lies in a file that `may_change` accepts; then there are no more errors than before. Where
// all together would leave more, each is tried by itself, and kept if it does not.
//
// Fixes of warnings are never applied: a task that compiles would mean something else, and which
// meaning is right its author knows. Throws as Analyze() does.
Mending Mend(const std::filesystem::path& file, const FileReader& read,
             const std::filesystem::path& robots,
             const std::function<bool(const std::string& file)>& may_change);

// Is it a file that its user may want to be mended: not a library's, and not write protected?
bool IsOwnFile(const std::string& file);

}  // namespace compiler
