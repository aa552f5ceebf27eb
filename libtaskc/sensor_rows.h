#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace libtaskc {

// Sensors whose numbers are read where they are, one row of a recording after the other.
class SensorRows {
 public:
  using Function = void (*)(const void** sensors, const ptrdiff_t* strides, size_t count);

  // `sensors`: where each is in the first row. `strides`: from one row to the next [bytes].
  SensorRows(std::span<const void*> sensors, std::vector<ptrdiff_t> strides);

  // Moves all to the next row.
  void Advance() const { advance_(sensors_.data(), strides_.data(), sensors_.size()); }

 private:
  std::span<const void*> sensors_;
  std::vector<ptrdiff_t> strides_;
  Function advance_;
};

}  // namespace libtaskc
