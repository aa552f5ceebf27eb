// Spelling suggestions: the name that was probably meant.
#pragma once

#include <cstddef>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>

namespace text {

// How many single mistakes turn one name into the other: a missing, an additional or a wrong
// character, or two neighbors swapped (Damerau's distance, each stretch edited at most once).
// Differences in case count as nothing.
size_t SpellingDistance(std::string_view a, std::string_view b);

// The largest distance at which `name` still looks like a misspelling: a third of its length, at
// least 1 and never the whole name.
size_t LargestPlausibleDistance(std::string_view name);

// The mistakes in all parts of a dotted name such as "base.velocity"; nothing where the two have
// another number of parts, or where one of them no longer looks like a misspelling.
std::optional<size_t> DottedDistance(std::string_view name, std::string_view candidate);

// The candidate nearest to `name`, the first of several equally near ones; nothing if none is near
// enough to be a misspelling. `candidates`: any range of strings.
template <std::ranges::input_range Candidates>
std::optional<std::string> NearestName(std::string_view name, const Candidates& candidates) {
  std::optional<std::string> nearest;
  size_t smallest = LargestPlausibleDistance(name) + 1;
  for (const auto& candidate : candidates) {
    const size_t distance = SpellingDistance(name, candidate);
    if (distance >= smallest) continue;
    smallest = distance;
    nearest = std::string(candidate);
  }
  return nearest;
}

}  // namespace text
