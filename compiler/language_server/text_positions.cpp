#include "compiler/language_server/text_positions.h"

#include <algorithm>

#include "base/text/utf8.h"

namespace compiler {
namespace {

uint32_t UnitsOf(const text::CodePoint& point, PositionEncoding encoding) {
  if (encoding == PositionEncoding::kUtf8) return point.length;
  return point.value >= 0x10000 ? 2 : 1;
}

}  // namespace

TextPositions::TextPositions(std::string_view text, PositionEncoding encoding)
    : text_(text), encoding_(encoding), starts_{0} {
  for (uint32_t i = 0; i < text.size(); ++i) {
    const bool is_pair = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if ((text[i] == '\n' || text[i] == '\r') && !is_pair) starts_.push_back(i + 1);
  }
}

TextPosition TextPositions::PositionOf(uint32_t offset) const {
  const auto next = std::upper_bound(starts_.begin(), starts_.end(), offset);
  const auto line = static_cast<uint32_t>(next - starts_.begin() - 1);
  const std::string_view text = LineAt(line);
  const size_t end = std::min<size_t>(offset - starts_[line], text.size());
  TextPosition position{line, 0};
  for (size_t i = 0; i < end;) {
    const text::CodePoint point = text::DecodeUtf8(text, i);
    if (i + point.length > end) break;
    position.column += UnitsOf(point, encoding_);
    i += point.length;
  }
  return position;
}

uint32_t TextPositions::OffsetOf(TextPosition position) const {
  if (position.line >= starts_.size()) return static_cast<uint32_t>(text_.size());
  const std::string_view text = LineAt(position.line);
  uint32_t offset = 0;
  for (uint32_t column = 0; offset < text.size();) {
    const text::CodePoint point = text::DecodeUtf8(text, offset);
    column += UnitsOf(point, encoding_);
    if (column > position.column) break;
    offset += point.length;
  }
  return starts_[position.line] + offset;
}

std::string_view TextPositions::LineAt(size_t line) const {
  const size_t end = line + 1 < starts_.size() ? starts_[line + 1] : text_.size();
  std::string_view text = text_.substr(starts_[line], end - starts_[line]);
  while (text.ends_with('\n') || text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

}  // namespace compiler
