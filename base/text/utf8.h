// Characters of a source text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace text {

struct CodePoint {
  char32_t value = 0;    // U+FFFD where the bytes are not UTF-8
  uint32_t length = 1;   // in bytes
  bool is_valid = true;  // false: `length` bytes that are not UTF-8
};

// The code point at `offset`, which must lie inside the text. Overlong forms, surrogates and values
// beyond U+10FFFF are not valid.
CodePoint DecodeUtf8(std::string_view text, size_t offset);

bool IsUtf8(std::string_view text);

// How many columns of a terminal a code point fills: 0, 1 or 2.
uint32_t DisplayWidth(char32_t value);
// The sum over a text without line ends and tabs.
uint32_t DisplayWidth(std::string_view text);

// True for characters that would disturb the display: control characters, the line ends of Unicode,
// and those that change the direction of writing.
bool IsUnprintable(char32_t value);

}  // namespace text
