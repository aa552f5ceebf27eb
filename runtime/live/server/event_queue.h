// Events on their way from the trainer to the clients that listen. No client can make them pile up:
// where it does not keep up, it misses events, and is told how many.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <set>
#include <string>

namespace runtime {

using EventText = std::shared_ptr<const std::string>;  // JSON, shared by all who send it

class EventQueue {
 public:
  explicit EventQueue(size_t limit) : limit_(limit) {}

  // Where the queue is full, events are missed until it is empty again: so all that are missed
  // follow each other.
  void Push(EventText event);
  // The next one, after the last the number of those missed: {"event": "missed", "count": 3}. Null
  // where there is nothing.
  EventText Pop();
  bool empty() const { return events_.empty() && missed_ == 0; }

 private:
  size_t limit_;
  std::deque<EventText> events_;
  int64_t missed_ = 0;
};

class EventListener {
 public:
  virtual ~EventListener() = default;
  virtual void Take(const EventText& event) = 0;
};

class EventHub {
 public:
  explicit EventHub(size_t limit) : limit_(limit), events_(limit) {}

  // Any thread.
  bool has_listeners() const { return has_listeners_; }
  // Any thread. Returns whether Deliver() must be called, because nothing was waiting before.
  bool Publish(EventText event);

  // These on one thread.
  void Add(EventListener& listener);
  void Remove(EventListener& listener);
  void Deliver();

 private:
  const size_t limit_;
  std::mutex mutex_;
  EventQueue events_;  // guarded by mutex_
  std::set<EventListener*> listeners_;
  std::atomic<bool> has_listeners_ = false;
};

}  // namespace runtime
