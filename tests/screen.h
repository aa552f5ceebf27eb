// What stands on a terminal after a program has printed.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

// All lines that a terminal of `columns` shows, those that have left the screen at the top first.
// Knows the codes with which a program goes up and erases; lines that are too long are wrapped.
// Characters are one column wide.
inline std::vector<std::string> ScreenLines(std::string_view printed, size_t columns) {
  std::vector<std::vector<std::string>> lines(1);  // [row][column]
  size_t row = 0;
  size_t column = 0;
  const auto go_down = [&] {
    if (++row == lines.size()) lines.emplace_back();
  };
  const auto is_continued = [&](size_t i) {
    return i < printed.size() && (static_cast<unsigned char>(printed[i]) & 0xC0) == 0x80;
  };
  for (size_t i = 0; i < printed.size(); ++i) {
    const char c = printed[i];
    if (c == '\r') {
      column = 0;
    } else if (c == '\n') {
      go_down();
    } else if (c == '\x1b') {
      size_t number = 0;
      for (i += 2; std::isdigit(static_cast<unsigned char>(printed[i])) != 0; ++i) {
        number = 10 * number + static_cast<size_t>(printed[i] - '0');
      }
      if (printed[i] == 'A') row -= std::min(row, std::max<size_t>(number, 1));
      if (printed[i] == 'K') lines[row].resize(column, " ");
    } else {
      if (column == columns) {
        go_down();
        column = 0;
      }
      lines[row].resize(std::max(lines[row].size(), column + 1), " ");
      std::string& cell = lines[row][column++] = c;
      while (is_continued(i + 1)) cell += printed[++i];
    }
  }
  std::vector<std::string> texts;
  for (const std::vector<std::string>& line : lines) {
    std::string& text = texts.emplace_back();
    for (const std::string& cell : line) text += cell;
  }
  return texts;
}
