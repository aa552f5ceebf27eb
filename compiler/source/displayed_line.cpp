#include "compiler/source/displayed_line.h"

#include <algorithm>

#include "base/text/utf8.h"

namespace compiler {
namespace {

constexpr std::string_view kGap = "...";
constexpr std::string_view kReplacement = "\uFFFD";
constexpr uint32_t kContext = 60;  // columns kept to the left of the focus in a long line

}  // namespace

DisplayedLine::DisplayedLine(std::string_view line) {
  columns_.reserve(line.size() + 1);
  for (size_t i = 0; i < line.size();) {
    const text::CodePoint point = text::DecodeUtf8(line, i);
    const uint32_t column = width_;
    cells_.push_back({column, static_cast<uint32_t>(text_.size())});
    if (point.value == '\t') {
      width_ += kTabWidth - width_ % kTabWidth;
      text_.append(width_ - column, ' ');
    } else if (!point.is_valid || text::IsUnprintable(point.value)) {
      width_ += 1;
      text_ += kReplacement;
    } else {
      width_ += text::DisplayWidth(point.value);
      text_ += line.substr(i, point.length);
    }
    columns_.insert(columns_.end(), point.length, column);
    i += point.length;
  }
  columns_.push_back(width_);
  cells_.push_back({width_, static_cast<uint32_t>(text_.size())});
}

DisplayedLine::Part DisplayedLine::PartAround(uint32_t focus) const {
  Part part;
  if (width_ > kMaxWidth && focus > kContext) part.first = std::min(focus, width_) - kContext;
  part.last = width_ <= kMaxWidth ? width_ : std::min(width_, part.first + kMaxWidth);
  if (part.first > 0) {
    part.text = kGap;
    part.indent = static_cast<uint32_t>(kGap.size());
  }
  const auto begin = std::ranges::lower_bound(cells_, part.first, {}, &Cell::column);
  const auto end = std::ranges::lower_bound(cells_, part.last, {}, &Cell::column);
  part.text += std::string_view(text_).substr(begin->text, end->text - begin->text);
  if (part.last < width_) part.text += kGap;
  return part;
}

}  // namespace compiler
