// Streams of random numbers, which their users' names tell apart.
#pragma once

#include <cstdint>
#include <string_view>

namespace compiler {

// FNV-1a, 32 bits (G. Fowler, L. C. Noll, K.-P. Vo).
constexpr uint32_t StreamOf(std::string_view name) {
  uint32_t hash = 0x811C9DC5;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193;
  return hash;
}

}  // namespace compiler
