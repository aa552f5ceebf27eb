// Writes lines of C++ and says, with `#line`, which line of the task each of them stands for.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace compiler {

// A line of one of the task's files.
struct SourceLine {
  std::string_view path;
  uint32_t line = 0;  // from 1; 0: no line of the task

  bool operator==(const SourceLine&) const = default;
};

// Which line of the task a line of the text stands for.
struct LineOrigin {
  uint32_t line = 0;  // of the text, from 1
  SourceLine source;
};

class TextWriter {
 public:
  // `own_path`: the name under which a debugger knows the C++ text.
  explicit TextWriter(std::string_view own_path);

  // Text of our own: one or more whole lines without the last end of line, indented.
  void Line(std::string_view text);
  // One line of C++ that stands for a line of the task.
  void Line(std::string_view text, SourceLine source);
  void BlankLine() { Line(""); }
  // What follows stands for nothing in the task.
  void LeaveSource();

  void Indent() { indent_ += 2; }
  void Outdent() { indent_ -= 2; }

  const std::string& text() const { return text_; }
  // Of the lines that stand for one of the task's, in their order.
  const std::vector<LineOrigin>& origins() const { return origins_; }

 private:
  void Append(std::string_view line);

  std::string own_path_;  // as a C++ literal
  std::string text_;
  std::vector<LineOrigin> origins_;
  size_t indent_ = 0;
  uint32_t physical_line_ = 1;  // of the next line
  SourceLine source_;           // what the C++ compiler takes the next line for
};

}  // namespace compiler
