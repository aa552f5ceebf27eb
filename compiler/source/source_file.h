// The text of one file of a task, and places in it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace compiler {

// A stretch of the text of one file: byte offsets, the end exclusive. An empty span marks a place
// between two characters. The files of a task are numbered consecutively: see
// Sources.
struct Span {
  uint32_t begin = 0;
  uint32_t end = 0;

  bool operator==(const Span&) const = default;
};

// The smallest span that covers both.
Span Cover(Span first, Span second);

// A place as a reader counts it: lines and columns from 1; a column is one UTF-8 code point.
struct Position {
  uint32_t line = 1;
  uint32_t column = 1;

  bool operator==(const Position&) const = default;
};

class SourceFile {
 public:
  // Of a `.task` file and of a table, in bytes: their parsers refuse what is larger.
  static constexpr uint32_t kMaxSize = 100'000;
  static constexpr uint32_t kMaxTableSize = 1'000'000;

  // `first_offset`: that of the first byte.
  SourceFile(std::string path, std::string text, uint32_t first_offset = 0);

  const std::string& path() const { return path_; }
  const std::string& text() const { return text_; }
  uint32_t first_offset() const { return first_offset_; }
  uint32_t end_offset() const { return first_offset_ + static_cast<uint32_t>(text_.size()); }
  // The text of a span of this file.
  std::string_view TextOf(Span span) const {
    return std::string_view(text_).substr(span.begin - first_offset_, span.end - span.begin);
  }

  // An offset beyond the text means its end; one inside a code point counts as that code point, one
  // inside a line's end as the end of the line.
  Position PositionOf(uint32_t offset) const;
  // Its line alone, which is quicker to find.
  uint32_t LineOf(uint32_t offset) const;
  // The offset at which a line begins.
  uint32_t LineStart(uint32_t line) const { return first_offset_ + line_starts_[line - 1]; }
  // A line's text without its end ("\n" or "\r\n"); lines count from 1.
  std::string_view Line(uint32_t line) const;
  uint32_t line_count() const { return static_cast<uint32_t>(line_starts_.size()); }

 private:
  // The begin of a code point within a long line: so that a line of 100 KB with an error at every
  // second byte is not counted through for each of them.
  struct Mark {
    uint32_t offset;  // within the text
    uint32_t before;  // code points of its line before it
  };

  void MarkLine(uint32_t line);

  std::string path_;
  std::string text_;
  uint32_t first_offset_;
  std::vector<uint32_t> line_starts_;  // within the text; never empty
  std::vector<Mark> marks_;            // in the order of the text
};

}  // namespace compiler
