#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "base/text/print.h"
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

// The marked lines of one file; the primary mark comes first in its line.
struct MarkedFile {
  const SourceFile* source;
  Span first;                                   // what was marked first
  std::map<uint32_t, std::vector<Mark>> marks;  // by line
};

// Each line of the files is laid out once, however many diagnostics show a part of it.
class DisplayedLines {
 public:
  // Of a line of a file that outlives this.
  const DisplayedLine& Of(std::string_view line) {
    return lines_.try_emplace(line.data(), line).first->second;
  }

 private:
  std::map<const char*, DisplayedLine> lines_;  // by the place of the line in memory
};

// Writes one diagnostic.
class Renderer {
 public:
  Renderer(const Sources& sources, DisplayedLines& lines, const Diagnostic& diagnostic, bool color)
      : sources_(sources), lines_(lines), diagnostic_(diagnostic), color_(color) {
    AddMark(diagnostic.span, true, diagnostic.note);
    for (const Label& label : diagnostic.labels) AddMark(label.span, false, label.text);
    for (const MarkedFile& file : files_) {
      gutter_ = std::max(gutter_, std::to_string(file.marks.rbegin()->first).size());
    }
  }

  std::string Render() {
    Heading();
    for (const MarkedFile& file : files_) {
      FileLine(&file == &files_.front() ? "-->" : ":::", file);
      SourceLines(file);
    }
    if (!diagnostic_.help.empty()) HelpLines();
    return std::move(out_);
  }

 private:
  // A span over several lines is marked in its first line.
  void AddMark(Span span, bool is_primary, std::string_view text) {
    MarkedFile& file = FileOf(span);
    const SourceFile& source = *file.source;
    const uint32_t line = source.LineOf(span.begin);
    const uint32_t start = source.LineStart(line);
    const auto length = static_cast<uint32_t>(source.Line(line).size());
    const uint32_t begin = std::min(span.begin - start, length);
    const uint32_t end = std::clamp(span.end > start ? span.end - start : 0, begin, length);
    file.marks[line].push_back({begin, end, is_primary, text});
  }

  // The file of a span among those that are marked already, or as a further one.
  MarkedFile& FileOf(Span span) {
    const SourceFile& source = sources_.FileOf(span);
    const auto found = std::ranges::find(files_, &source, &MarkedFile::source);
    if (found != files_.end()) return *found;
    return files_.emplace_back(MarkedFile{&source, span, {}});
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
    out_ += Colored(SeverityColor(), kind) +
            Colored(kBold, ": " + text::Visible(diagnostic_.message)) + "\n";
  }

  // " --> a.task:12:3"
  void FileLine(std::string_view arrow, const MarkedFile& file) {
    const Position position = file.source->PositionOf(file.first.begin);
    out_ += std::string(gutter_, ' ') + Colored(kBlue, arrow) + " " +
            text::Visible(file.source->path()) + ":" + std::to_string(position.line) + ":" +
            std::to_string(position.column) + "\n";
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

  void SourceLines(const MarkedFile& file) {
    uint32_t previous = 0;
    for (const auto& [line, marks] : file.marks) {
      if (previous != 0) Between(*file.source, previous, line);
      SourceLine(*file.source, line, marks);
      previous = line;
    }
  }

  // The lines between two marked ones: left out, but a single one is shown.
  void Between(const SourceFile& source, uint32_t previous, uint32_t next) {
    if (next == previous + 2) {
      const DisplayedLine& line = lines_.Of(source.Line(previous + 1));
      GutterLine(std::to_string(previous + 1), line.PartAround(0).text);
    } else if (next > previous + 2) {
      out_ += Colored(kBlue, "...") + "\n";
    }
  }

  void SourceLine(const SourceFile& source, uint32_t number, const std::vector<Mark>& marks) {
    const DisplayedLine& line = lines_.Of(source.Line(number));
    const DisplayedLine::Part part = line.PartAround(line.ColumnOf(marks.front().begin));
    GutterLine(std::to_string(number), part.text);
    for (const Mark& mark : marks) MarkLine(line, part, mark);
  }

  void MarkLine(const DisplayedLine& line, const DisplayedLine::Part& part, const Mark& mark) {
    const uint32_t begin = std::clamp(line.ColumnOf(mark.begin), part.first, part.last);
    const uint32_t end = std::clamp(line.ColumnOf(mark.end), begin, part.last);
    std::string signs(std::max(1u, end - begin), mark.is_primary ? '^' : '-');
    if (!mark.text.empty()) signs += ' ';
    signs += text::Visible(mark.text);
    std::string marked(part.indent + begin - part.first, ' ');
    marked += Colored(mark.is_primary ? SeverityColor() : kBlue, signs);
    GutterLine("", marked);
  }

  void HelpLines() {
    const std::string blanks(gutter_, ' ');
    GutterLine("", "");
    out_ += blanks + Colored(kBlue, " =") + " " + Colored(kCyan, "help:") + " ";
    for (const char c : text::Visible(diagnostic_.help.text)) {
      out_ += c;
      if (c == '\n') out_ += blanks + "         ";
    }
    out_ += "\n";
  }

  const Sources& sources_;
  DisplayedLines& lines_;
  const Diagnostic& diagnostic_;
  const bool color_;
  std::vector<MarkedFile> files_;  // that of the diagnostic itself first
  size_t gutter_ = 1;              // width of the line numbers
  std::string out_;
};

}  // namespace

std::string Render(const Sources& sources, const Diagnostics& diagnostics, bool color) {
  std::string out;
  DisplayedLines lines;
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    out += Renderer(sources, lines, diagnostic, color).Render() + "\n";
  }
  return out;
}

}  // namespace compiler
