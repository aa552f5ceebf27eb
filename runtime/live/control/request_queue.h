// Where requests wait until the thread that trains can do them.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <vector>

#include "runtime/live/control/command_table.h"
#include "runtime/live/control/request.h"
#include "runtime/live/control/task_loader.h"

namespace runtime {

// A request with all that had to be prepared for it.
struct QueuedRequest {
  const CommandSpec* command = nullptr;
  nlohmann::json arguments;
  ReplyHandler reply;
  LoadedTask task;  // where the command takes the file of one
};

class RequestQueue {
 public:
  // Any thread. After Close() the request is refused at once.
  void Push(QueuedRequest request);
  // Refuses all that still wait, and whatever comes.
  void Close();

  // The thread that trains. Looking takes no lock.
  bool has_requests() const { return has_requests_.load(std::memory_order_acquire); }
  std::vector<QueuedRequest> TakeAll();
  // Until there is one, or the time is over.
  void WaitFor(std::chrono::milliseconds time);

 private:
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::vector<QueuedRequest> requests_;
  std::atomic<bool> has_requests_ = false;
  bool is_closed_ = false;
};

}  // namespace runtime
