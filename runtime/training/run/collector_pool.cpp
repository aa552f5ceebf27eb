#include "runtime/training/run/collector_pool.h"

#include <algorithm>
#include <utility>

#include "runtime/core/task/plugin_watch.h"

namespace runtime {

CollectorPool::CollectorPool(int threads, MakeCollector make)
    : make_(std::move(make)), places_(2 * static_cast<size_t>(threads)) {
  for (size_t i = 0; i < static_cast<size_t>(threads); ++i) {
    threads_.emplace_back([this, i](const std::stop_token& stop) { Work(stop, i); });
  }
}

CollectorPool::~CollectorPool() { FreeAll(); }

void CollectorPool::Work(const std::stop_token& stop, size_t thread) {
  std::unique_lock lock(mutex_);
  while (started_.wait(lock, stop, [this] { return !waiting_.empty(); })) {
    Place& place = *waiting_.front();
    waiting_.pop_front();
    place.state = State::kRuns;
    lock.unlock();
    {
      const WatchedThread watched(thread + 1);
      place.collector->Run(are_unwanted_);
    }
    lock.lock();
    place.state = State::kIsDone;
    done_.notify_all();
  }
}

CollectorPool::Place& CollectorPool::PlaceOf(const Collector& collector) {
  return *std::ranges::find_if(
      places_, [&](const Place& place) { return place.collector.get() == &collector; });
}

Collector* CollectorPool::FindFree() {
  std::unique_lock lock(mutex_);
  const auto free = std::ranges::find(places_, State::kFree, &Place::state);
  lock.unlock();
  if (free == places_.end()) return nullptr;
  if (free->collector == nullptr) free->collector = make_();
  return free->collector.get();
}

void CollectorPool::Start(const Collector& collector) {
  const std::lock_guard lock(mutex_);
  Place& place = PlaceOf(collector);
  place.state = State::kWaits;
  waiting_.push_back(&place);
  started_.notify_one();
}

Collector* CollectorPool::Find(int64_t episode) {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find_if(places_, [&](const Place& place) {
    return place.state != State::kFree && place.collector->episode() == episode;
  });
  return found == places_.end() ? nullptr : found->collector.get();
}

bool CollectorPool::IsDone(const Collector& collector, std::chrono::milliseconds time) {
  std::unique_lock lock(mutex_);
  const Place& place = PlaceOf(collector);
  return done_.wait_for(lock, time, [&] { return place.state == State::kIsDone; });
}

void CollectorPool::Free(const Collector& collector) {
  const std::lock_guard lock(mutex_);
  PlaceOf(collector).state = State::kFree;
}

void CollectorPool::FreeAll() {
  are_unwanted_ = true;
  std::unique_lock lock(mutex_);
  waiting_.clear();
  done_.wait(lock, [this] {
    return std::ranges::none_of(places_,
                                [](const Place& place) { return place.state == State::kRuns; });
  });
  for (Place& place : places_) place.state = State::kFree;
  are_unwanted_ = false;
}

void CollectorPool::Renew() {
  FreeAll();
  for (Place& place : places_) place.collector = nullptr;
}

}  // namespace runtime
