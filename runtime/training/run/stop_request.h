// Ctrl-C and the signal to terminate, as a request that the run checks between two episodes.
#pragma once

#include <string_view>

namespace runtime {

// How what is said where one has come begins.
inline constexpr std::string_view kStopNotice = "stopping after this episode";

// While it lives, the first SIGINT or SIGTERM is only noted. At most one at a time.
class StopRequest {
 public:
  // What a second one does; from the third on they end the process in any case.
  enum class Second { kEndsTheProcess, kIsNoted };

  explicit StopRequest(Second second = Second::kEndsTheProcess);
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;
  ~StopRequest();

  // The signal that was received, or 0.
  int signal() const;
  // A second one has come.
  bool is_urgent() const;
};

}  // namespace runtime
