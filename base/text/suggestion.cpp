#include "base/text/suggestion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text/nearest_name.h"

namespace text {

std::string Suggestion(std::string_view name, const std::vector<std::string>& candidates) {
  if (const auto nearest = NearestName(name, candidates)) {
    return fmt::format(": did you mean `{}`?", *nearest);
  }
  if (candidates.empty()) return ": there are none";
  return fmt::format("; there {} `{}`", candidates.size() == 1 ? "is only" : "are",
                     fmt::join(candidates, "`, `"));
}

}  // namespace text
