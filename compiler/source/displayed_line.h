// One source line as a terminal shows it, and the place of each byte in it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace compiler {

// Tabs reach to the next multiple of 4; characters that would disturb the display, and bytes that
// are not UTF-8, appear as U+FFFD.
class DisplayedLine {
 public:
  static constexpr uint32_t kTabWidth = 4;
  static constexpr uint32_t kMaxWidth =
      140;  // of a line shown whole; of a longer one, a part is shown

  explicit DisplayedLine(std::string_view line);

  // The display column (from 0) at which the byte at `offset` of the line begins; one past the last
  // for the line's end.
  uint32_t ColumnOf(uint32_t offset) const { return columns_[offset]; }

  // The part of the line to show so that the column `focus` is well visible.
  struct Part {
    std::string text;
    uint32_t first = 0;   // the display column of the line that `text` begins with
    uint32_t last = 0;    // the one after its end
    uint32_t indent = 0;  // what stands before it: the width of "..." or nothing
  };
  Part PartAround(uint32_t focus) const;

 private:
  struct Cell {
    uint32_t column;
    uint32_t text;  // where its part of text_ begins
  };
  std::string text_;
  std::vector<Cell> cells_;        // one for each code point and one for the end
  std::vector<uint32_t> columns_;  // one for each byte and one for the end
  uint32_t width_ = 0;
};

}  // namespace compiler
