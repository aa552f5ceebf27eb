// Damage to bytes that are no text: three bytes of a text say where, the fourth what stands there.
#pragma once

#include <string>
#include <string_view>

namespace fuzz {

// `bytes`, damaged in as many places as `edits` has groups of four.
inline std::string Damaged(std::string bytes, std::string_view edits) {
  const auto byte = [&](size_t i) { return static_cast<unsigned char>(edits[i]); };
  for (size_t i = 0; i + 4 <= edits.size() && !bytes.empty(); i += 4) {
    const size_t place = byte(i) | size_t{byte(i + 1)} << 8 | size_t{byte(i + 2)} << 16;
    bytes[place % bytes.size()] = edits[i + 3];
  }
  return bytes;
}

}  // namespace fuzz
