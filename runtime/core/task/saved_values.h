// Texts and numbers in a checkpoint: as the machine has them in memory, each text after its length.
#pragma once

#include <cstdint>
#include <istream>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>

#include "runtime/base/user_error.h"

namespace runtime {

template <class Number>
requires std::is_arithmetic_v<Number>
void SaveNumber(std::ostream& stream, Number number) {
  stream.write(reinterpret_cast<const char*>(&number), sizeof number);
}

inline void SaveText(std::ostream& stream, std::string_view text) {
  SaveNumber(stream, static_cast<uint32_t>(text.size()));
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
}

// All of these throw UserError if the stream ends early.
inline void LoadBytes(std::istream& stream, char* bytes, size_t count) {
  if (!stream.read(bytes, static_cast<std::streamsize>(count))) {
    throw UserError("the checkpoint of the task is cut off");
  }
}

template <class Number>
requires std::is_arithmetic_v<Number> Number LoadNumber(std::istream& stream) {
  Number number;
  LoadBytes(stream, reinterpret_cast<char*>(&number), sizeof number);
  return number;
}

inline std::string LoadText(std::istream& stream) {
  constexpr uint32_t kLongest = 1u << 28;
  const auto size = LoadNumber<uint32_t>(stream);
  if (size > kLongest) throw UserError("the checkpoint of the task is damaged");
  std::string text(size, '\0');
  LoadBytes(stream, text.data(), size);
  return text;
}

}  // namespace runtime
