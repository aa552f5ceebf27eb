#include "base/command_line/roff.h"

#include <fmt/format.h>

#include "base/text/utf8.h"

namespace command_line {
namespace {

// A sign that would mean something, or that a terminal would show as another one.
std::string_view Escape(char c) {
  switch (c) {
    case '\\':
      return "\\(rs";
    case '-':
      return "\\-";
    case '\'':
      return "\\(aq";
    case '^':
      return "\\(ha";
    case '~':
      return "\\(ti";
    case '`':
      return "\\(ga";
    default:
      return {};
  }
}

void Append(std::string& out, std::string_view text, size_t& at) {
  const text::CodePoint point = text::DecodeUtf8(text, at);
  if (point.value >= 0x80) {
    out += fmt::format("\\[u{:04X}]", static_cast<uint32_t>(point.value));
  } else if (const std::string_view escaped = Escape(text[at]); !escaped.empty()) {
    out += escaped;
  } else {
    // A line that begins so would be a request.
    if (text[at] == '.' && (out.empty() || out.back() == '\n')) out += "\\&";
    out += text[at];
  }
  at += point.length;
}

std::string Escaped(std::string_view text) {
  std::string out;
  for (size_t at = 0; at < text.size();) Append(out, text, at);
  return out;
}

}  // namespace

std::string RoffText(std::string_view text) {
  std::string out;
  bool is_code = false;
  for (size_t at = 0; at < text.size();) {
    const bool is_quote = text[at] == '`' && (is_code || text.find('`', at + 1) != text.npos);
    if (!is_quote) {
      Append(out, text, at);
      continue;
    }
    is_code = !is_code;
    out += is_code ? "\\fB" : "\\fR";
    ++at;
  }
  return out;
}

std::string RoffBold(std::string_view text) { return "\\fB" + Escaped(text) + "\\fR"; }

std::string RoffItalic(std::string_view text) { return "\\fI" + Escaped(text) + "\\fR"; }

std::string RoffLines(std::string_view lines) {
  return fmt::format(".RS 2\n.nf\n{}\n.fi\n.RE\n", Escaped(lines));
}

}  // namespace command_line
