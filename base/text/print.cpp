#include "base/text/print.h"

#include "base/text/utf8.h"

namespace text {

std::string Visible(std::string_view text) {
  std::string visible;
  visible.reserve(text.size());
  for (size_t i = 0; i < text.size();) {
    const CodePoint point = DecodeUtf8(text, i);
    const bool is_layout = point.value == '\n' || point.value == '\t';
    if (!point.is_valid) {
      visible += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[i]));
    } else if (!is_layout && IsUnprintable(point.value)) {
      visible += fmt::format("\\u{:04x}", static_cast<uint32_t>(point.value));
    } else {
      visible += text.substr(i, point.length);
    }
    i += point.length;
  }
  return visible;
}

}  // namespace text
