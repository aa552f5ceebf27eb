#include "compiler/emit/line_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>

namespace compiler {
namespace {

using Place = std::pair<std::string_view, uint32_t>;  // of the task: file and line

// "103-104, 131"; `lines` ascend.
std::string Ranges(const std::vector<uint32_t>& lines) {
  std::string text;
  for (size_t first = 0; first < lines.size();) {
    size_t last = first;
    while (last + 1 < lines.size() && lines[last + 1] == lines[last] + 1) ++last;
    if (!text.empty()) text += ", ";
    text += fmt::format("{}", lines[first]);
    if (last > first) text += fmt::format("-{}", lines[last]);
    first = last + 1;
  }
  return text;
}

}  // namespace

std::string LineMap(const std::vector<LineOrigin>& origins) {
  std::map<Place, std::vector<uint32_t>> lines;
  for (const LineOrigin& origin : origins) {
    lines[{origin.source.path, origin.source.line}].push_back(origin.line);
  }
  size_t width = 0;
  const auto name = [](const Place& place) {
    return fmt::format("{}:{}", place.first, place.second);
  };
  for (const auto& [place, numbers] : lines) width = std::max(width, name(place).size());
  std::string text;
  for (const auto& [place, numbers] : lines) {
    text += fmt::format("{:{}}  {}\n", name(place), width, Ranges(numbers));
  }
  return text;
}

}  // namespace compiler
