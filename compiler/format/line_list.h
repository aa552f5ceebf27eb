// The lines of a formatted file while they come into being.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace compiler {

class LineList {
 public:
  // Begins a line, after a blank one where that is wanted.
  void Begin(uint32_t indentation, bool after_blank);
  // At the end of the current line.
  void Append(std::string_view text);
  // The comment after the current line's code.
  void AddTrailingComment(std::string_view comment);

  // Columns of the current line.
  uint32_t width() const;

  // All lines, each ended by `line_end`. Trailing comments of neighboring lines stand in one
  // column.
  std::string Join(std::string_view line_end);

 private:
  struct Line {
    std::string code;
    std::string comment;
  };
  void AlignComments();

  std::vector<Line> lines_;
};

}  // namespace compiler
