#include "libtaskc_sim/worker_threads.h"

#include "runtime/core/task/plugin_watch.h"

namespace libtaskc_sim {

WorkerThreads::WorkerThreads(size_t count) {
  threads_.reserve(count - 1);
  for (size_t i = 1; i < count; ++i) threads_.emplace_back([this, i] { Work(i); });
}

WorkerThreads::~WorkerThreads() {
  ends_ = true;
  ++jobs_;
  jobs_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void WorkerThreads::Run(size_t items, Function function, void* job) {
  function_ = function;
  job_ = job;
  items_ = items;
  next_item_ = 0;
  const bool is_shared = items > 1 && !threads_.empty();
  if (is_shared) {
    working_ = static_cast<uint32_t>(threads_.size());
    ++jobs_;
    jobs_.notify_all();
  }
  DoItems();
  if (!is_shared) return;
  for (uint32_t left = working_; left > 0; left = working_) working_.wait(left);
}

// Each thread has another place in the watch: what is counted there for each event of a task lies
// in a cache line of its own.
void WorkerThreads::Work(size_t place) {
  const runtime::WatchedThread watched(1 + place % (runtime::PluginWatch::kMostThreads - 1));
  for (uint32_t done = 0;; ++done) {
    jobs_.wait(done);
    if (ends_) return;
    DoItems();
    if (--working_ == 0) working_.notify_one();
  }
}

void WorkerThreads::DoItems() {
  for (size_t i = next_item_++; i < items_; i = next_item_++) function_(job_, i);
}

}  // namespace libtaskc_sim
