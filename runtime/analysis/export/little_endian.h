// Numbers as files that other programs read have them.
#pragma once

#include <concepts>
#include <string>

namespace runtime {

template <std::unsigned_integral Number>
void AppendLittleEndian(Number value, std::string& bytes) {
  for (size_t i = 0; i < sizeof(Number); ++i) bytes += static_cast<char>(value >> 8 * i & 0xFF);
}

}  // namespace runtime
