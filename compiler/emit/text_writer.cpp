#include "compiler/emit/text_writer.h"

#include <fmt/format.h>

#include "compiler/emit/cpp_literal.h"

namespace compiler {

TextWriter::TextWriter(std::string_view source_path, std::string_view own_path)
    : source_path_(StringLiteral(source_path)), own_path_(StringLiteral(own_path)) {}

void TextWriter::Line(std::string_view text) {
  while (true) {
    size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (!line.empty()) text_.append(indent_, ' ');
    Append(line);
    if (end == std::string_view::npos) return;
    text.remove_prefix(end + 1);
  }
}

void TextWriter::Line(std::string_view text, uint32_t source_line) {
  if (source_line_ == 0) {
    Append(fmt::format("#line {} {}", source_line, source_path_));
  } else if (source_line_ != source_line) {
    Append(fmt::format("#line {}", source_line));
  }
  source_line_ = source_line;
  Line(text);
}

void TextWriter::LeaveSource() {
  if (source_line_ == 0) return;
  Append(fmt::format("#line {} {}", physical_line_ + 1, own_path_));
  source_line_ = 0;
}

void TextWriter::Append(std::string_view line) {
  text_ += line;
  text_ += '\n';
  ++physical_line_;
  if (source_line_ != 0 && !line.starts_with("#line")) ++source_line_;
}

}  // namespace compiler
