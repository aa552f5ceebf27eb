#include "compiler/language_server/uri.h"

#include <fmt/format.h>

#include <cctype>

namespace compiler {
namespace {

constexpr std::string_view kScheme = "file://";

std::optional<char> ByteOf(std::string_view digits) {
  if (digits.size() != 2) return std::nullopt;
  int value = 0;
  for (const char digit : digits) {
    if (std::isxdigit(static_cast<unsigned char>(digit)) == 0) return std::nullopt;
    const int low = std::tolower(digit);
    value = 16 * value + (low >= 'a' ? low - 'a' + 10 : low - '0');
  }
  return static_cast<char>(value);
}

}  // namespace

std::optional<std::filesystem::path> PathOfUri(std::string_view uri) {
  if (!uri.starts_with(kScheme)) return std::nullopt;
  uri.remove_prefix(kScheme.size());
  const size_t begin = uri.find('/');  // behind the host, which is left out or "localhost"
  if (begin == std::string_view::npos) return std::nullopt;
  std::string path;
  for (size_t i = begin; i < uri.size(); ++i) {
    const auto byte = uri[i] == '%' ? ByteOf(uri.substr(i + 1, 2)) : std::nullopt;
    path += byte.value_or(uri[i]);
    if (byte) i += 2;
  }
  return std::filesystem::path(path).lexically_normal();
}

std::string UriOfPath(const std::filesystem::path& path) {
  std::string uri(kScheme);
  for (const char c : std::filesystem::absolute(path).lexically_normal().string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain =
        std::isalnum(byte) != 0 || std::string_view("/-._~").find(c) != std::string_view::npos;
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return uri;
}

}  // namespace compiler
