// Other programs, run to their end.
#pragma once

#include <string>
#include <system_error>
#include <vector>

namespace runtime {

// What of a child's output is for us. The rest goes to the user, all of it to our standard error:
// our standard output may be read by a program. With kOutputOnly, messages go nowhere.
enum class Captured { kNothing, kOutput, kOutputOnly, kMessages };

struct ChildResult {
  std::error_code error;  // why it could not be started
  bool is_success = false;
  std::string captured;
};

// Runs words[0], which is looked for in PATH if it is no path, with the other words. Throws
// UserError where the system has no pipe left.
ChildResult RunChild(std::vector<std::string> words, Captured captured);

}  // namespace runtime
