// Ctrl-C and the signal to terminate, as a wish that the run looks at between two episodes.
#pragma once

namespace runtime {

// While it lives, the first SIGINT or SIGTERM is only noted; a second one ends the process at once.
// At most one at a time.
class StopRequest {
 public:
  StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;
  ~StopRequest();

  // The signal that was received, or 0.
  int signal() const;
};

}  // namespace runtime
