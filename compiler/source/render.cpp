#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "compiler/source/diagnostic.h"
#include "compiler/source/displayed_line.h"

namespace compiler {
namespace {

constexpr std::string_view kReset = "\033[0m";
constexpr std::string_view kBold = "\033[1m";
constexpr std::string_view kRed = "\033[1;31m";
constexpr std::string_view kYellow = "\033[1;33m";
constexpr std::string_view kBlue = "\033[1;34m";
constexpr std::string_view kCyan = "\033[1;36m";

// Carets or dashes under a part of one line, and what is written behind them.
struct Mark {
  uint32_t begin;  // byte offsets within the line
  uint32_t end;
  bool is_primary;
  std::string_view text;
};

// Writes one diagnostic.
class Renderer {
 public:
  Renderer(const SourceFile& source, const Diagnostic& diagnostic, bool color)
      : source_(source), diagnostic_(diagnostic), color_(color) {
    AddMark(diagnostic.span, true, diagnostic.note);
    for (const Label& label : diagnostic.labels) AddMark(label.span, false, label.text);
    gutter_ = std::to_string(marks_.rbegin()->first).size();
  }

  std::string Render() {
    Heading();
    uint32_t previous = 0;
    for (const auto& [line, marks] : marks_) {
      if (previous != 0) Between(previous, line);
      SourceLine(line, marks);
      previous = line;
    }
    if (!diagnostic_.help.empty()) Help();
    return std::move(out_);
  }

 private:
  // A span over several lines is marked in its first line.
  void AddMark(Span span, bool is_primary, std::string_view text) {
    const uint32_t line = source_.PositionOf(span.begin).line;
    const uint32_t start = source_.LineStart(line);
    const auto length = static_cast<uint32_t>(source_.Line(line).size());
    const uint32_t begin = std::min(span.begin - start, length);
    const uint32_t end = std::clamp(span.end > start ? span.end - start : 0, begin, length);
    marks_[line].push_back({begin, end, is_primary, text});
  }

  std::string_view SeverityColor() const {
    return diagnostic_.severity == Severity::kError ? kRed : kYellow;
  }

  std::string Colored(std::string_view color, std::string_view text) const {
    if (!color_) return std::string(text);
    return std::string(color) + std::string(text) + std::string(kReset);
  }

  void Heading() {
    const bool is_error = diagnostic_.severity == Severity::kError;
    const std::string kind = (is_error ? "error[" : "warning[") + diagnostic_.code + "]";
    const Position position = source_.PositionOf(diagnostic_.span.begin);
    out_ += Colored(SeverityColor(), kind) + Colored(kBold, ": " + diagnostic_.message) + "\n";
    out_ += std::string(gutter_, ' ') + Colored(kBlue, "-->") + " " + source_.path() + ":" +
            std::to_string(position.line) + ":" + std::to_string(position.column) + "\n";
    GutterLine("", "");
  }

  // " 12 | text"; trailing blanks are not written.
  void GutterLine(std::string_view number, std::string_view text) {
    std::string gutter(gutter_ - number.size(), ' ');
    gutter += number;
    gutter += " |";
    out_ += Colored(kBlue, gutter);
    if (!text.empty()) out_ += ' ';
    out_ += text;
    out_ += '\n';
  }

  // The lines between two marked ones: left out, but a single one is shown.
  void Between(uint32_t previous, uint32_t next) {
    if (next == previous + 2) {
      const DisplayedLine line(source_.Line(previous + 1));
      GutterLine(std::to_string(previous + 1), line.PartAround(0).text);
    } else if (next > previous + 2) {
      out_ += Colored(kBlue, "...") + "\n";
    }
  }

  void SourceLine(uint32_t number, const std::vector<Mark>& marks) {
    const DisplayedLine line(source_.Line(number));
    const DisplayedLine::Part part = line.PartAround(line.ColumnOf(marks.front().begin));
    GutterLine(std::to_string(number), part.text);
    for (const Mark& mark : marks) MarkLine(line, part, mark);
  }

  void MarkLine(const DisplayedLine& line, const DisplayedLine::Part& part, const Mark& mark) {
    const uint32_t begin = std::clamp(line.ColumnOf(mark.begin), part.first, part.last);
    const uint32_t end = std::clamp(line.ColumnOf(mark.end), begin, part.last);
    std::string signs(std::max(1u, end - begin), mark.is_primary ? '^' : '-');
    if (!mark.text.empty()) signs += ' ';
    signs += mark.text;
    std::string marked(part.indent + begin - part.first, ' ');
    marked += Colored(mark.is_primary ? SeverityColor() : kBlue, signs);
    GutterLine("", marked);
  }

  void Help() {
    const std::string blanks(gutter_, ' ');
    GutterLine("", "");
    out_ += blanks + Colored(kBlue, " =") + " " + Colored(kCyan, "help:") + " ";
    for (const char c : diagnostic_.help) {
      out_ += c;
      if (c == '\n') out_ += blanks + "         ";
    }
    out_ += "\n";
  }

  const SourceFile& source_;
  const Diagnostic& diagnostic_;
  const bool color_;
  std::map<uint32_t, std::vector<Mark>> marks_;  // by line; the primary one first in its line
  size_t gutter_ = 1;                            // width of the line numbers
  std::string out_;
};

}  // namespace

std::string Render(const SourceFile& source, const Diagnostics& diagnostics, bool color) {
  std::string out;
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    out += Renderer(source, diagnostic, color).Render() + "\n";
  }
  return out;
}

}  // namespace compiler
