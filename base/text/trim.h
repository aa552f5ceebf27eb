#pragma once

#include <algorithm>
#include <string_view>

namespace text {

inline constexpr std::string_view kBlanks = " \t\r\n\f";

// Without the blanks at both ends. It points into `text` even where nothing is left of it.
inline std::string_view Trimmed(std::string_view text) {
  const size_t begin = std::min(text.find_first_not_of(kBlanks), text.size());
  const size_t end = std::max(text.find_last_not_of(kBlanks) + 1, begin);
  return text.substr(begin, end - begin);
}

}  // namespace text
