#include "compiler/source/source_file.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/text/utf8.h"

namespace compiler {
namespace {

constexpr uint32_t kBetweenMarks = 256;  // bytes, at least

}  // namespace

Span Cover(Span first, Span second) {
  return {std::min(first.begin, second.begin), std::max(first.end, second.end)};
}

SourceFile::SourceFile(std::string path, std::string text, uint32_t first_offset)
    : path_(std::move(path)), text_(std::move(text)), first_offset_(first_offset), line_starts_{0} {
  for (uint32_t i = 0; i < text_.size(); ++i) {
    if (text_[i] == '\n') line_starts_.push_back(i + 1);
  }
  for (uint32_t line = 1; line <= line_count(); ++line) MarkLine(line);
}

void SourceFile::MarkLine(uint32_t number) {
  const std::string_view line = Line(number);
  uint32_t next = kBetweenMarks;
  uint32_t before = 0;
  for (uint32_t i = 0; line.size() > kBetweenMarks && i < line.size(); ++before) {
    if (i >= next) {
      marks_.push_back({line_starts_[number - 1] + i, before});
      next = i + kBetweenMarks;
    }
    i += static_cast<uint32_t>(text::DecodeUtf8(line, i).length);
  }
}

Position SourceFile::PositionOf(uint32_t offset) const {
  Position position;
  position.line = LineOf(offset);
  const std::string_view line = Line(position.line);
  const size_t end = std::min<size_t>(offset - LineStart(position.line), line.size());
  const uint32_t begin = line_starts_[position.line - 1];
  const auto next =
      std::upper_bound(marks_.begin(), marks_.end(), begin + end,
                       [](size_t place, const Mark& mark) { return place < mark.offset; });
  const bool is_marked = next != marks_.begin() && std::prev(next)->offset > begin;
  const Mark from = is_marked ? *std::prev(next) : Mark{begin, 0};
  position.column += from.before;
  for (size_t i = from.offset - begin; i < end;) {
    i += text::DecodeUtf8(line, i).length;
    if (i <= end) ++position.column;
  }
  return position;
}

uint32_t SourceFile::LineOf(uint32_t offset) const {
  const auto next =
      std::upper_bound(line_starts_.begin(), line_starts_.end(), offset - first_offset_);
  return static_cast<uint32_t>(next - line_starts_.begin());
}

std::string_view SourceFile::Line(uint32_t line) const {
  const uint32_t begin = line_starts_[line - 1];
  size_t end = line < line_count() ? line_starts_[line] - 1 : text_.size();
  if (end > begin && text_[end - 1] == '\r') --end;
  return std::string_view(text_).substr(begin, end - begin);
}

}  // namespace compiler
