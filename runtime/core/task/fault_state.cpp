#include "runtime/core/task/fault_state.h"

#include <algorithm>
#include <cstring>

namespace runtime {

FaultState::FaultState(host::TaskFrame& host)
    : host_(host),
      memory_(host.memory().size()),
      memory_before_(host.memory().size()),
      params_(host.params().size()) {
  const taskc_plugin& table = host.plugin();
  size_t size = 0;
  for (size_t i = 0; i < table.sensor_count; ++i) {
    sensor_offsets_.push_back(size);
    size += host::SizeInBytes(table.sensors[i]);
  }
  sensor_offsets_.push_back(size);
  sensors_.resize(size);
}

void FaultState::NoteMemory() {
  if (!is_kept_ && !memory_before_.empty()) {
    std::memcpy(memory_before_.data(), host_.memory().data(), memory_before_.size());
  }
}

void FaultState::Keep(int event, size_t term, double time_step) {
  if (is_kept_) return;
  is_kept_ = true;
  event_ = event;
  term_ = term;
  time_step_ = time_step;
  seed_ = host_.frame().seed;
  discount_ = host_.frame().discount;
  outcome_ = host_.frame().outcome;
  std::ranges::copy(host_.params(), params_.begin());
  memory_ = memory_before_;
  const taskc_plugin& table = host_.plugin();
  for (size_t i = 0; i < table.sensor_count; ++i) {
    const size_t size = sensor_offsets_[i + 1] - sensor_offsets_[i];
    std::byte* const kept = sensors_.data() + sensor_offsets_[i];
    const bool is_read = (table.sensors[i].read_by >> static_cast<unsigned>(event) & 1u) != 0;
    if (is_read && host_.sensor(i) != nullptr) {
      std::memcpy(kept, host_.sensor(i), size);
    } else {
      std::memset(kept, 0, size);
    }
  }
}

std::span<const std::byte> FaultState::sensor(size_t index) const {
  const size_t begin = sensor_offsets_[index];
  return std::span(sensors_).subspan(begin, sensor_offsets_[index + 1] - begin);
}

std::span<const std::byte> FaultState::memory(const taskc_memory& variable) const {
  return std::span(memory_).subspan(variable.offset, host::SizeInBytes(variable));
}

}  // namespace runtime
