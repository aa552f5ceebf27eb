#include "libtaskc/sensor_rows.h"

#include <utility>

namespace libtaskc {
namespace {

constexpr size_t kMostFew = 16;

void Advance(const void** sensors, const ptrdiff_t* strides, size_t count) {
  for (size_t i = 0; i < count; ++i)
    sensors[i] = static_cast<const std::byte*>(sensors[i]) + strides[i];
}

// As it is called in each time step, few sensors are moved without counting them.
template <size_t kCount>
void AdvanceFew(const void** sensors, const ptrdiff_t* strides, size_t) {
  Advance(sensors, strides, kCount);
}

template <size_t... kCounts>
SensorRows::Function FunctionFor(size_t count, std::index_sequence<kCounts...>) {
  constexpr SensorRows::Function kFew[] = {AdvanceFew<kCounts>...};
  return count < sizeof...(kCounts) ? kFew[count] : Advance;
}

}  // namespace

SensorRows::SensorRows(std::span<const void*> sensors, std::vector<ptrdiff_t> strides)
    : sensors_(sensors),
      strides_(std::move(strides)),
      advance_(FunctionFor(sensors_.size(), std::make_index_sequence<kMostFew + 1>())) {}

}  // namespace libtaskc
