#include "base/text/nearest_name.h"

#include <algorithm>
#include <vector>

namespace text {
namespace {

char Lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool Same(char a, char b) { return Lower(a) == Lower(b); }

}  // namespace

size_t SpellingDistance(std::string_view a, std::string_view b) {
  // Rows of the usual table: the current prefix of `a` against every prefix of `b`.
  std::vector<size_t> before_last(b.size() + 1);
  std::vector<size_t> last(b.size() + 1);
  std::vector<size_t> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    std::swap(before_last, last);
    std::swap(last, row);
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t wrong = last[j - 1] + (Same(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, wrong});
      const bool swapped = i > 1 && j > 1 && Same(a[i - 1], b[j - 2]) && Same(a[i - 2], b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

size_t LargestPlausibleDistance(std::string_view name) {
  if (name.size() < 2) return 0;
  return std::max<size_t>(1, name.size() / 3);
}

std::optional<size_t> DottedDistance(std::string_view name, std::string_view candidate) {
  size_t sum = 0;
  while (true) {
    const size_t end = name.find('.');
    const size_t candidate_end = candidate.find('.');
    const std::string_view part = name.substr(0, end);
    const size_t distance = SpellingDistance(part, candidate.substr(0, candidate_end));
    if (distance > LargestPlausibleDistance(part)) return std::nullopt;
    sum += distance;
    const bool is_last = end == std::string_view::npos;
    if (is_last != (candidate_end == std::string_view::npos)) return std::nullopt;
    if (is_last) return sum;
    name.remove_prefix(end + 1);
    candidate.remove_prefix(candidate_end + 1);
  }
}

}  // namespace text
