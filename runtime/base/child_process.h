// Other programs, run to their end.
#pragma once

#include <chrono>
#include <stop_token>
#include <string>
#include <system_error>
#include <vector>

namespace runtime {

// What of a child's output is for us. The rest goes to the user, all of it to our standard error:
// our standard output may be read by a program. With kOutputOnly, messages go nowhere; kMessages
// are what it says on both, as it comes.
enum class Captured { kNothing, kOutput, kOutputOnly, kMessages };

// When a child is killed, with all that it has started.
struct ChildLimits {
  std::chrono::milliseconds patience = std::chrono::minutes(2);
  std::stop_token stop = {};  // may be asked for on any thread
};

struct ChildResult {
  std::error_code error;  // why it could not be started
  bool is_success = false;
  bool was_too_slow = false;  // killed because its time was over
  std::string captured;
};

// Runs words[0], which is searched for in PATH if it is not a path, with the other words. The child
// has a process group of its own; nothing of it outlives this call, and it dies with this process,
// however that ends. Throws UserError where the system has no pipe or process left.
ChildResult RunChild(std::vector<std::string> words, Captured captured,
                     const ChildLimits& limits = {});

}  // namespace runtime
