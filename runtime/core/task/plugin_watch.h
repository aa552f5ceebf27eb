// What is inside of a plugin at this moment, so that another process can tell after a crash.
#pragma once

#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace runtime {

// Read by a guarding process if it lies in memory that both share.
struct PluginWatch {
  // Of a thread that runs tasks, and written by it alone.
  struct alignas(64) Thread {          // in a cache line of its own
    std::atomic<int64_t> running = 0;  // TaskInstance::id() of what runs now; 0: no plugin does
    std::atomic<int64_t> calls = 0;    // that have returned, so that one that loops is seen
    std::atomic<pid_t> id = 0;         // gettid(); 0: there is no such thread now
  };
  static constexpr size_t kMostThreads = 128;
  // The first is the process's own, whose id is never written; the others run episodes ahead.
  std::array<Thread, kMostThreads> threads;
  // Written by the one that loads them: the thread (gettid()) in which the code of a shared object
  // runs while it is loaded, 0: in none; and how many were loaded before.
  std::atomic<pid_t> loading_thread = 0;
  std::atomic<int64_t> loads = 0;
};

namespace detail {
inline PluginWatch own_watch;
inline PluginWatch* the_watch = &own_watch;
inline thread_local size_t the_thread = 0;  // its place among the threads of the watch
}  // namespace detail

// That of this process. Until SetPluginWatch() it lies in memory of its own.
inline PluginWatch& ThePluginWatch() { return *detail::the_watch; }
// `watch` outlives all task instances.
inline void SetPluginWatch(PluginWatch& watch) { detail::the_watch = &watch; }

// While it lives, this thread has another place than the first.
class WatchedThread {
 public:
  // `place`: below PluginWatch::kMostThreads, and nobody else's.
  explicit WatchedThread(size_t place) : watch_(ThePluginWatch().threads[place]) {
    detail::the_thread = place;
    watch_.id.store(gettid(), std::memory_order_relaxed);
  }
  WatchedThread(const WatchedThread&) = delete;
  WatchedThread& operator=(const WatchedThread&) = delete;
  ~WatchedThread() {
    watch_.id.store(0, std::memory_order_relaxed);
    detail::the_thread = 0;
  }

 private:
  PluginWatch::Thread& watch_;
};

// While it lives, this thread is inside of the task with this id.
class InsideOfTask {
 public:
  explicit InsideOfTask(int64_t id) { watch_.running.store(id, std::memory_order_relaxed); }
  InsideOfTask(const InsideOfTask&) = delete;
  InsideOfTask& operator=(const InsideOfTask&) = delete;
  ~InsideOfTask() {
    watch_.running.store(0, std::memory_order_relaxed);
    const int64_t calls = watch_.calls.load(std::memory_order_relaxed);
    watch_.calls.store(calls + 1, std::memory_order_relaxed);
  }

 private:
  PluginWatch::Thread& watch_ = ThePluginWatch().threads[detail::the_thread];
};

}  // namespace runtime
