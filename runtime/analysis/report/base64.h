// Numbers as text that the page decodes (web/src/data/base64.ts).
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace runtime {

// RFC 4648, with padding.
std::string EncodeBase64(std::span<const std::byte> bytes);

// Little-endian float32 values; half the size of digits, and exact.
std::string EncodeFloats(std::span<const float> values);

}  // namespace runtime
