#include "compiler/syntax/power_help.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "compiler/syntax/token_classes.h"

namespace compiler {
namespace {

bool IsWordCharacter(char c) {
  return c == '_' || c == '.' || std::isalnum(static_cast<unsigned char>(c)) != 0;
}

// Where the operand begins that ends with `text`: a word with members, brackets and calls behind
// it.
size_t BeginOfOperand(std::string_view text) {
  size_t begin = text.size();
  int depth = 0;
  while (begin > 0) {
    const char c = text[begin - 1];
    if (c == ')' || c == ']') ++depth;
    const bool is_opening = c == '(' || c == '[';
    if (is_opening && depth == 0) break;
    if (is_opening) --depth;
    if (depth == 0 && !is_opening && !IsWordCharacter(c)) break;
    --begin;
  }
  return begin;
}

std::string_view Trimmed(std::string_view text) {
  const size_t end = text.find_last_not_of(" \t");
  return end == std::string_view::npos ? "" : text.substr(0, end + 1);
}

// The integer that `text` begins with, behind blanks.
std::string_view LeadingDigits(std::string_view text, size_t& end) {
  const size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
  end = std::min(text.find_first_not_of("0123456789", begin), text.size());
  return text.substr(begin, end - begin);
}

bool IsUnitName(std::string_view word) {
  const auto units = UnitNames();
  return std::ranges::find(units, word) != units.end();
}

}  // namespace

Help HelpForPower(const SourceFile& source, Span sign, std::string_view exponent) {
  const uint32_t line_start = source.LineStart(source.LineOf(sign.begin));
  const std::string_view line = source.Line(source.LineOf(sign.begin));
  const std::string_view before = Trimmed(line.substr(0, sign.begin - line_start));
  const std::string_view behind = line.substr(sign.end - line_start);
  const size_t begin = BeginOfOperand(before);
  const std::string_view operand = before.substr(begin);
  if (IsUnitName(operand)) return DidYouMean(sign, "^" + std::string(exponent));
  size_t end = 0;
  if (exponent.empty()) exponent = LeadingDigits(behind, end);
  const Span whole{line_start + static_cast<uint32_t>(begin),
                   sign.end + static_cast<uint32_t>(end)};
  if (operand.empty() || exponent.empty())
    return "a square is a product, `x * x`; `pow(x, y)` is the power of plain numbers";
  if (exponent != "2")
    return {fmt::format("write `pow({}, {})`, which takes plain numbers", operand, exponent),
            {{whole, fmt::format("pow({}, {})", operand, exponent)}}};
  const bool is_divisor = Trimmed(before.substr(0, begin)).ends_with('/');
  std::string square = fmt::format("{0} * {0}", operand);
  if (is_divisor) square = "(" + square + ")";
  return {fmt::format("a square is a product: write `{}`", square), {{whole, square}}};
}

Help HelpForPowerInName(const std::string& name, Span span) {
  const size_t digits = name.find_first_of("0123456789");
  const bool is_power = digits != std::string::npos && digits + 1 == name.size();
  if (!is_power || !IsUnitName(name.substr(0, digits))) return {};
  const std::string written = name.substr(0, digits) + "^" + name.substr(digits);
  return {fmt::format("the power of a unit is written `{}`", written), {{span, written}}};
}

}  // namespace compiler
