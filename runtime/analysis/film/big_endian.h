// Numbers as the files of films have them.
#pragma once

#include <cstdint>
#include <string>

namespace runtime {

// The last `count` bytes of `value`, the greatest first.
inline std::string BigEndian(uint64_t value, int count) {
  std::string bytes;
  for (int i = count - 1; i >= 0; --i) bytes += static_cast<char>(value >> (8 * i));
  return bytes;
}

}  // namespace runtime
