// What is inside of a plugin at this moment, so that another process can tell after a crash.
#pragma once

#include <atomic>
#include <cstdint>

namespace runtime {

// Written by the one thread that runs tasks; read by a guarding process if it lies in memory that
// both share.
struct PluginWatch {
  std::atomic<int64_t> running = 0;      // TaskInstance::id() of what runs now; 0: no plugin does
  std::atomic<int64_t> calls = 0;        // that have returned, so that one that loops is seen
  std::atomic<bool> is_loading = false;  // a shared object, which can crash or loop as well
};

namespace detail {
inline PluginWatch own_watch;
inline PluginWatch* the_watch = &own_watch;
}  // namespace detail

// That of this process. Until SetPluginWatch() it lies in memory of its own.
inline PluginWatch& ThePluginWatch() { return *detail::the_watch; }
// `watch` outlives all task instances.
inline void SetPluginWatch(PluginWatch& watch) { detail::the_watch = &watch; }

}  // namespace runtime
