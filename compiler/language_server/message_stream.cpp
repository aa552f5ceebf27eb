#include "compiler/language_server/message_stream.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>

namespace compiler {
namespace {

// Larger messages are none: a file has a megabyte at most.
constexpr size_t kLargest = 100'000'000;

std::optional<size_t> LengthIn(std::string line) {
  std::ranges::transform(line, line.begin(), [](unsigned char c) { return std::tolower(c); });
  constexpr std::string_view kName = "content-length:";
  if (!line.starts_with(kName)) return std::nullopt;
  const size_t begin = std::min(line.find_first_not_of(" \t", kName.size()), line.size());
  size_t length = 0;
  const auto [end, error] = std::from_chars(line.data() + begin, line.data() + line.size(), length);
  return error == std::errc{} && length <= kLargest ? std::optional(length) : std::nullopt;
}

}  // namespace

std::optional<std::string> ReadMessage(std::istream& in) {
  size_t length = 0;
  bool has_header = false;
  for (std::string line; std::getline(in, line);) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty() && !has_header) continue;
    if (line.empty()) {
      std::string content(length, '\0');
      in.read(content.data(), static_cast<std::streamsize>(length));
      if (!in) return std::nullopt;
      return content;
    }
    has_header = true;
    length = LengthIn(line).value_or(length);
  }
  return std::nullopt;
}

void WriteMessage(std::ostream& out, const std::string& content) {
  out << "Content-Length: " << content.size() << "\r\n\r\n" << content << std::flush;
}

}  // namespace compiler
