#include "compiler/syntax/characters.h"

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "base/text/utf8.h"

namespace compiler {
namespace {

bool IsHidden(char32_t value, std::string_view behind) {
  if (value == '\r') return !behind.starts_with('\n');
  return value != '\t' && value != '\n' && text::IsUnprintable(value);
}

Diagnostic HiddenCharacter(char32_t value, Span span) {
  const bool is_control = value < 0xA0;
  Diagnostic diagnostic = MakeDiagnostic(
      code::kHiddenCharacter, span,
      fmt::format("the {} U+{:04X} cannot be seen", is_control ? "control character" : "character",
                  static_cast<uint32_t>(value)));
  if (value == '\r') {
    diagnostic.help = "end a line with a line feed, or with carriage return and line feed";
  } else if (is_control) {
    diagnostic.help = "remove it";
  } else {
    diagnostic.help =
        "remove it: with it, a file can read differently from what is compiled; letters that are "
        "written from right to left need no such character";
  }
  return diagnostic;
}

}  // namespace

bool IsInOtherEncoding(SyntaxReport& report) {
  const std::string_view text = report.source().text();
  const auto begins = [&](std::string_view bytes) { return text.starts_with(bytes); };
  using namespace std::string_view_literals;
  std::string_view encoding;
  if (begins("\xFF\xFE\0\0"sv) || begins("\0\0\xFE\xFF"sv)) {
    encoding = "UTF-32";
  } else if (begins("\xFF\xFE"sv) || begins("\xFE\xFF"sv) ||
             (text.size() > 1 && (text[0] == '\0') != (text[1] == '\0'))) {
    encoding = "UTF-16";
  }
  if (encoding.empty()) return false;
  const uint32_t begin = report.source().first_offset();
  Diagnostic diagnostic = MakeDiagnostic(code::kInvalidUtf8, {begin, begin},
                                         fmt::format("the file is in {}, not in UTF-8", encoding));
  diagnostic.help = "save the file in the encoding UTF-8";
  report.Add(std::move(diagnostic));
  return true;
}

void CheckCharacters(SyntaxReport& report) {
  const std::string& text = report.source().text();
  for (uint32_t i = 0; i < text.size();) {
    const text::CodePoint point = text::DecodeUtf8(text, i);
    const uint32_t begin = report.source().first_offset() + i;
    if (!point.is_valid) {
      Diagnostic diagnostic = MakeDiagnostic(code::kInvalidUtf8, {begin, begin + 1},
                                             "this byte is not part of a character");
      diagnostic.help = "save the file in the encoding UTF-8";
      return report.Add(std::move(diagnostic));
    }
    if (IsHidden(point.value, std::string_view(text).substr(i + point.length))) {
      return report.Add(HiddenCharacter(point.value, {begin, begin + point.length}));
    }
    i += point.length;
  }
}

}  // namespace compiler
