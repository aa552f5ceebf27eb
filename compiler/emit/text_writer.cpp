#include "compiler/emit/text_writer.h"

#include <fmt/format.h>

#include "compiler/emit/cpp_literal.h"

namespace compiler {

TextWriter::TextWriter(std::string_view own_path) : own_path_(StringLiteral(own_path)) {}

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

void TextWriter::Line(std::string_view text, SourceLine source) {
  if (source_.path != source.path) {
    Append(fmt::format("#line {} {}", source.line, StringLiteral(source.path)));
  } else if (source_.line != source.line) {
    Append(fmt::format("#line {}", source.line));
  }
  source_ = source;
  origins_.push_back({physical_line_, source});
  Line(text);
}

void TextWriter::LeaveSource() {
  if (source_ == SourceLine{}) return;
  Append(fmt::format("#line {} {}", physical_line_ + 1, own_path_));
  source_ = {};
}

void TextWriter::Append(std::string_view line) {
  text_ += line;
  text_ += '\n';
  ++physical_line_;
  if (source_.line != 0 && !line.starts_with("#line")) ++source_.line;
}

}  // namespace compiler
