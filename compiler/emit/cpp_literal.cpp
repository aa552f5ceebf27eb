#include "compiler/emit/cpp_literal.h"

#include <fmt/format.h>

#include <cmath>

namespace compiler {
namespace {

void AppendEscaped(std::string& literal, char character) {
  switch (character) {
    case '"':
      literal += "\\\"";
      return;
    case '\\':
      literal += "\\\\";
      return;
    case '\n':
      literal += "\\n";
      return;
    case '?':  // two in a row may start a trigraph
      literal += literal.ends_with('?') ? "\\?" : "?";
      return;
    default:
      break;
  }
  if (character >= ' ' && character <= '~') {
    literal += character;
  } else {
    // Always three digits, so that a digit that follows is not taken in.
    literal += fmt::format("\\{:03o}", static_cast<unsigned char>(character));
  }
}

}  // namespace

std::string StringLiteral(std::string_view text) {
  std::string literal = "\"";
  for (char character : text) AppendEscaped(literal, character);
  return literal + '"';
}

std::string SplitStringLiteral(std::string_view text, std::string_view indent) {
  std::string literal;
  do {
    size_t end = text.find('\n');
    size_t length = end == std::string_view::npos ? text.size() : end + 1;
    if (!literal.empty()) literal += '\n';
    literal += indent;
    literal += StringLiteral(text.substr(0, length));
    text.remove_prefix(length);
  } while (!text.empty());
  return literal;
}

std::string RealLiteral(double value) {
  if (std::isnan(value)) return "__builtin_nan(\"\")";
  if (std::isinf(value)) return value > 0 ? "__builtin_inf()" : "-__builtin_inf()";
  std::string literal = fmt::format("{}", value);
  if (literal.find_first_of(".e") == std::string::npos) literal += ".0";
  return literal;
}

std::string IntLiteral(double value) { return fmt::format("{}LL", static_cast<long long>(value)); }

}  // namespace compiler
