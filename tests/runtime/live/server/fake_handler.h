// A trainer that does nothing but note what it was asked for.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "runtime/live/control/request.h"

namespace runtime {

// Replies to each request with its command and arguments, except for `unload`, which it refuses,
// and `save`, which it replies to when it is told to.
class FakeHandler : public RequestHandler {
 public:
  void Handle(Request request, ReplyHandler reply) override {
    ++count_;
    if (request.command == "save") return Keep(std::move(reply));
    if (request.command == "unload") {
      return reply({.ok = false, .error = "there is no task module `shadow`\nthere is `task`"});
    }
    reply({.value = {{"command", request.command}, {"arguments", request.arguments}}});
  }

  void Watch(const ViewWish& wish) override {
    const std::lock_guard lock(mutex_);
    wish_ = wish;
  }
  ViewWish wish() {
    const std::lock_guard lock(mutex_);
    return wish_;
  }

  int count() const { return count_; }

  // Waits for the next `save`, and hands out what answers it.
  ReplyHandler TakeSave() {
    std::unique_lock lock(mutex_);
    is_kept_.wait(lock, [this] { return !kept_.empty(); });
    ReplyHandler reply = std::move(kept_.back());
    kept_.pop_back();
    return reply;
  }

 private:
  void Keep(ReplyHandler reply) {
    const std::lock_guard lock(mutex_);
    kept_.push_back(std::move(reply));
    is_kept_.notify_one();
  }

  std::atomic<int> count_ = 0;
  std::mutex mutex_;
  std::condition_variable is_kept_;
  std::vector<ReplyHandler> kept_;
  ViewWish wish_;
};

}  // namespace runtime
