// The text of a task as ANTLR's lexer reads it.
#pragma once

#include <antlr4-runtime.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "compiler/source/source_file.h"

namespace compiler {

// Each byte is one character, and the first has the file's first offset, so that the places of
// tokens are byte offsets as in a Span. Characters beyond ASCII occur only in comments and texts,
// where their bytes pass through.
class ByteStream : public antlr4::ANTLRInputStream {
 public:
  explicit ByteStream(const SourceFile& source) : first_offset_(source.first_offset()) {
    const std::string_view text = source.text();
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    _data.reserve(text.size());
    for (const char c : text) _data.push_back(static_cast<unsigned char>(c));
    if (text.starts_with(kByteOrderMark)) std::fill_n(_data.begin(), kByteOrderMark.size(), U' ');
  }

  size_t size() override { return first_offset_ + ANTLRInputStream::size(); }
  size_t index() override { return first_offset_ + ANTLRInputStream::index(); }
  void seek(size_t index) override { ANTLRInputStream::seek(index - first_offset_); }
  // What has not been read yet.
  std::u32string_view rest() const { return std::u32string_view(_data).substr(p); }

  std::string getText(const antlr4::misc::Interval& interval) override {
    const auto shift = static_cast<ssize_t>(first_offset_);
    return ANTLRInputStream::getText({interval.a - shift, interval.b - shift});
  }

 private:
  const uint32_t first_offset_;
};

}  // namespace compiler
