#include "runtime/live/control/request_queue.h"

#include <utility>

namespace runtime {
namespace {

void Refuse(const QueuedRequest& request) { request.reply({false, {}, "the trainer has ended"}); }

}  // namespace

void RequestQueue::Push(QueuedRequest request) {
  {
    const std::lock_guard lock(mutex_);
    if (!is_closed_) {
      requests_.push_back(std::move(request));
      has_requests_.store(true, std::memory_order_release);
      arrived_.notify_one();
      return;
    }
  }
  Refuse(request);
}

void RequestQueue::Close() {
  {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
  }
  for (const QueuedRequest& request : TakeAll()) Refuse(request);
}

std::vector<QueuedRequest> RequestQueue::TakeAll() {
  const std::lock_guard lock(mutex_);
  has_requests_.store(false, std::memory_order_release);
  return std::exchange(requests_, {});
}

void RequestQueue::WaitFor(std::chrono::milliseconds time) {
  std::unique_lock lock(mutex_);
  arrived_.wait_for(lock, time, [this] { return !requests_.empty(); });
}

}  // namespace runtime
