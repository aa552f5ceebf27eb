// Places in a text as the Language Server Protocol counts them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace compiler {

// In what a column is counted.
enum class PositionEncoding { kUtf8, kUtf16 };

struct TextPosition {
  uint32_t line = 0;    // from 0
  uint32_t column = 0;  // from 0, in units of the encoding

  bool operator==(const TextPosition&) const = default;
};

// Lines end with "\n", "\r\n" or "\r".
class TextPositions {
 public:
  TextPositions(std::string_view text, PositionEncoding encoding);

  // Offsets beyond the end mean the end; one inside a character means that character.
  TextPosition PositionOf(uint32_t offset) const;
  // The other way round: columns beyond a line mean its end, lines beyond the last the text's end.
  uint32_t OffsetOf(TextPosition position) const;

 private:
  std::string_view LineAt(size_t line) const;  // without its end

  std::string_view text_;
  PositionEncoding encoding_;
  std::vector<uint32_t> starts_;
};

}  // namespace compiler
