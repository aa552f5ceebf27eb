#include "base/text/cells.h"

#include <charconv>

#include "base/text/trim.h"

namespace text {
namespace {

std::string_view WithoutQuotes(std::string_view cell) {
  const bool is_quoted = cell.size() > 1 && cell.starts_with('"') && cell.ends_with('"');
  return is_quoted ? Trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

}  // namespace

std::vector<std::string_view> CellsOf(std::string_view line) {
  std::vector<std::string_view> cells;
  while (true) {
    const size_t comma = line.find(',');
    cells.push_back(WithoutQuotes(Trimmed(line.substr(0, comma))));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

std::errc ReadNumber(std::string_view cell, double& number) {
  if (cell.starts_with('+')) cell.remove_prefix(1);
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  return end == cell.data() + cell.size() ? error : std::errc::invalid_argument;
}

}  // namespace text
