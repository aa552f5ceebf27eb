// Threads that run the episodes of collectors.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "runtime/training/run/collector.h"

namespace runtime {

// Used by the thread that trains. There are more collectors than threads, so that threads have
// something to do while episodes that are done wait for their turn.
class CollectorPool {
 public:
  using MakeCollector = std::function<std::unique_ptr<Collector>()>;

  // `make` is called by FindFree().
  CollectorPool(int threads, MakeCollector make);
  CollectorPool(const CollectorPool&) = delete;
  CollectorPool& operator=(const CollectorPool&) = delete;
  ~CollectorPool();

  // One that has nothing to do; null where all have.
  Collector* FindFree();
  // Has the episode run that it was prepared for, after those that were started before.
  void Start(const Collector& collector);
  // The one with this episode, whether it is done or not; null where there is none.
  Collector* Find(int64_t episode);
  // Whether its episode is done within the time.
  bool IsDone(const Collector& collector, std::chrono::milliseconds time);
  // It has handed over what it had.
  void Free(const Collector& collector);
  // Frees all; returns when none is running any more.
  void FreeAll();
  // FreeAll(), and new ones will be made.
  void Renew();

 private:
  enum class State { kFree, kWaits, kRuns, kIsDone };
  struct Place {
    std::unique_ptr<Collector> collector;  // null: not made yet
    State state = State::kFree;
  };

  Place& PlaceOf(const Collector& collector);
  void Work(const std::stop_token& stop, size_t thread);

  const MakeCollector make_;
  std::vector<Place> places_;  // states are guarded by the mutex
  std::mutex mutex_;
  std::condition_variable_any started_;
  std::condition_variable done_;
  std::deque<Place*> waiting_;
  std::atomic<bool> are_unwanted_ = false;
  std::vector<std::jthread> threads_;  // the last: they use all others
};

}  // namespace runtime
