// Whether a plugin in another process comes back.
#pragma once

#include <sys/types.h>

#include <array>
#include <cstdint>

#include "runtime/core/task/plugin_watch.h"

namespace runtime {

// To be asked every now and then.
class LoopDetector {
 public:
  static constexpr double kPatience = 10;  // [s] of the thread's CPU time in one call of a plugin

  // `process`: the one with the watch.
  explicit LoopDetector(pid_t process) : process_(process) {}

  // Whether one and the same call, in whatever thread, or the loading of one shared object takes
  // longer than it should.
  bool IsLooping(const PluginWatch& watch);

 private:
  // One thread, and what it has been inside of since when.
  struct Stay {
    int64_t what = 0;  // 0: of nothing
    double since = 0;  // [s] of the thread's CPU time
    bool IsTooLong(int64_t what_now, double now);
  };

  pid_t process_;
  std::array<Stay, PluginWatch::kMostThreads> calls_;
  Stay loading_;
};

}  // namespace runtime
