// The text of a task as ANTLR's lexer reads it.
#pragma once

#include <antlr4-runtime.h>

#include <string_view>

namespace compiler {

// Each byte is one character, so that the places of tokens are byte offsets as in a Span.
// Characters beyond ASCII occur only in comments and texts, where their bytes pass through.
class ByteStream : public antlr4::ANTLRInputStream {
 public:
  explicit ByteStream(std::string_view text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    _data.reserve(text.size());
    for (const char c : text) _data.push_back(static_cast<unsigned char>(c));
    if (text.starts_with(kByteOrderMark)) std::fill_n(_data.begin(), kByteOrderMark.size(), U' ');
  }
};

}  // namespace compiler
