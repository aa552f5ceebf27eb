// Writes lines of C++ and says, with `#line`, which line of the task each of them stands for.
#pragma once

#include <string>
#include <string_view>

namespace compiler {

class TextWriter {
 public:
  // `source_path` is the task's file; `own_path` the name under which a debugger knows the C++
  // text.
  TextWriter(std::string_view source_path, std::string_view own_path);

  // Text of our own: one or more whole lines without the last end of line, indented.
  void Line(std::string_view text);
  // One line of C++ that stands for line `source_line` of the task.
  void Line(std::string_view text, uint32_t source_line);
  void BlankLine() { Line(""); }
  // What follows stands for nothing in the task.
  void LeaveSource();

  void Indent() { indent_ += 2; }
  void Outdent() { indent_ -= 2; }

  const std::string& text() const { return text_; }

 private:
  void Append(std::string_view line);

  std::string source_path_;  // as C++ literals
  std::string own_path_;
  std::string text_;
  size_t indent_ = 0;
  uint32_t physical_line_ = 1;  // of the next line
  uint32_t source_line_ =
      0;  // that the C++ compiler takes the next line for; 0: none of the task's
};

}  // namespace compiler
