// What a task worked on when it first meant to pay what is not finite: enough to compute that again
// elsewhere, and to say where it came from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plugins/host/task_frame.h"

namespace runtime {

class FaultState {
 public:
  // Takes all memory that it will ever need. Refers to `host`, which must outlive this.
  explicit FaultState(host::TaskFrame& host);

  void StartEpisode() { is_kept_ = false; }
  // Before each call of an event: what the task remembers then.
  void NoteMemory();
  // After the call in which the term was not paid. Only the first one of an episode is kept, with
  // the sensors that the event reads.
  void Keep(int event, size_t term, double time_step);

  // All of the following is of the first fault in the episode, and there is none without one.
  bool is_kept() const { return is_kept_; }
  int event() const { return event_; }  // TASKC_START_OF_EPISODE ...
  size_t term() const { return term_; }
  double time_step() const { return time_step_; }  // [s]
  uint64_t seed() const { return seed_; }          // that decides what is drawn
  double discount() const { return discount_; }
  int outcome() const { return outcome_; }  // TASKC_SUCCESS ...
  std::span<const double> params() const { return params_; }
  // In the units and types of the table's entries; a sensor that the event does not read is 0.
  std::span<const std::byte> sensor(size_t index) const;
  std::span<const std::byte> memory(const taskc_memory& variable) const;

 private:
  host::TaskFrame& host_;
  std::vector<size_t> sensor_offsets_;  // one more than there are sensors
  std::vector<std::byte> sensors_;
  std::vector<std::byte> memory_;
  std::vector<std::byte> memory_before_;
  std::vector<double> params_;
  bool is_kept_ = false;
  int event_ = 0;
  size_t term_ = 0;
  double time_step_ = 0;
  uint64_t seed_ = 0;
  double discount_ = 1;
  int outcome_ = 0;
};

}  // namespace runtime
