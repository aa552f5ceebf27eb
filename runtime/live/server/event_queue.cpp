#include "runtime/live/server/event_queue.h"

#include <fmt/format.h>

#include <utility>

namespace runtime {

void EventQueue::Push(EventText event) {
  if (missed_ > 0 || events_.size() >= limit_) {
    ++missed_;
  } else {
    events_.push_back(std::move(event));
  }
}

EventText EventQueue::Pop() {
  if (!events_.empty()) {
    EventText event = std::move(events_.front());
    events_.pop_front();
    return event;
  }
  const int64_t missed = std::exchange(missed_, 0);
  if (missed == 0) return nullptr;
  return std::make_shared<std::string>(fmt::format(R"({{"event":"missed","count":{}}})", missed));
}

bool EventHub::Publish(EventText event) {
  const std::lock_guard lock(mutex_);
  const bool was_empty = events_.empty();
  events_.Push(std::move(event));
  return was_empty;
}

void EventHub::Add(EventListener& listener) {
  listeners_.insert(&listener);
  has_listeners_ = true;
}

void EventHub::Remove(EventListener& listener) {
  listeners_.erase(&listener);
  has_listeners_ = !listeners_.empty();
}

void EventHub::Deliver() {
  EventQueue events(limit_);
  {
    const std::lock_guard lock(mutex_);
    std::swap(events, events_);
  }
  while (const EventText event = events.Pop()) {
    for (EventListener* listener : listeners_) listener->Take(event);
  }
}

}  // namespace runtime
