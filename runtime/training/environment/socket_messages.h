// What both sides of the messages of docs/environments.md have in common: the trainer that asks an
// environment, and the environment that it offers itself.
#pragma once

#include <cstdint>

#include "runtime/core/module/values.h"

namespace runtime {

inline constexpr int kSocketVersion = 1;

// The first byte of a binary request.
inline constexpr uint8_t kBinaryReset = 1;
inline constexpr uint8_t kBinaryStep = 2;
inline constexpr uint8_t kBinarySet = 3;  // only to an environment that the trainer offers

// The first byte of a binary reply: how the episode goes on.
inline constexpr uint8_t kBinaryGoesOn = 0;
constexpr uint8_t BinaryEnd(EndKind kind) {
  return static_cast<uint8_t>(1 + static_cast<int>(kind));
}

}  // namespace runtime
