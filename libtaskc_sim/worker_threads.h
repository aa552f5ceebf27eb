#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace libtaskc_sim {

// Threads that do the items of a job side by side; who gives the job helps. Belongs to one thread.
class WorkerThreads {
 public:
  // `count`: of all that do the items, at least 1.
  explicit WorkerThreads(size_t count);
  WorkerThreads(const WorkerThreads&) = delete;
  WorkerThreads& operator=(const WorkerThreads&) = delete;
  ~WorkerThreads();

  size_t count() const { return threads_.size() + 1; }

  // Calls do_item(i), which must not throw, for each i below `items`; returns when all are done.
  template <class DoItem>
  void ForEach(size_t items, DoItem do_item) {
    Run(
        items, [](void* job, size_t i) { (*static_cast<DoItem*>(job))(i); }, &do_item);
  }

 private:
  using Function = void (*)(void* job, size_t item);

  void Run(size_t items, Function function, void* job);
  void Work(size_t place);
  void DoItems();

  // The job. Written while no thread works.
  Function function_ = nullptr;
  void* job_ = nullptr;
  size_t items_ = 0;
  bool ends_ = false;

  std::atomic<size_t> next_item_ = 0;
  std::atomic<uint32_t> jobs_ = 0;     // that were given; whoever waits for one waits for this
  std::atomic<uint32_t> working_ = 0;  // threads that are not done with the present one
  std::vector<std::thread> threads_;
};

}  // namespace libtaskc_sim
