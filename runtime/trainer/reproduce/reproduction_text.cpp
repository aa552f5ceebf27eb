#include "runtime/trainer/reproduce/reproduction_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace runtime {
namespace {

constexpr size_t kMostValues = 8;  // of an episode, that a person wants to see

std::string FirstEpisodes(int64_t count) {
  return count == 1 ? "episode 1" : fmt::format("episodes 1 to {}", count);
}

std::string EqualText(const Reproduction& found) {
  std::string text = fmt::format("{}: {} trained again from the record: equal, bit for bit",
                                 found.name, FirstEpisodes(found.episodes));
  if (found.changes > 0) {
    text += fmt::format(", with {} live change{}", found.changes, found.changes == 1 ? "" : "s");
  }
  if (found.is_state_equal) text += "; so is what was learned";
  return text + "\n";
}

std::string DifferenceText(const Reproduction& found) {
  if (found.differences.empty()) {
    return fmt::format("{}: {} are equal, but what was learned is not\n", found.name,
                       FirstEpisodes(found.episodes));
  }
  std::string text = fmt::format(
      "{}: episode {} differs{}:\n", found.name, found.equal + 1,
      found.equal == 0
          ? ""
          : fmt::format("; {} equal", found.equal == 1
                                          ? "the one before is"
                                          : fmt::format("the {} before are", found.equal)));
  const size_t shown = std::min(found.differences.size(), kMostValues);
  for (size_t i = 0; i < shown; ++i) {
    const ValueDifference& each = found.differences[i];
    text +=
        fmt::format("  {:<24} {} in the record, {} here\n", each.name, each.recorded, each.here);
  }
  if (found.differences.size() > shown) {
    text += fmt::format("  and {} more\n", found.differences.size() - shown);
  }
  return text;
}

std::string CausesText(const Reproduction& found) {
  std::string differing;
  std::string unknown;
  for (const CauseComparison& each : found.causes) {
    if (each.recorded.empty()) {
      unknown += (unknown.empty() ? "" : ", ") + each.name;
    } else if (!each.is_equal()) {
      differing +=
          fmt::format("  {:<24} {} in the record, {} here\n", each.name, each.recorded, each.here);
    }
  }
  std::string text = differing.empty()
                         ? "what computes is the same as in the record, as far as that says\n"
                         : "what computes differs as well:\n" + differing;
  if (!unknown.empty()) text += fmt::format("the record does not say: {}\n", unknown);
  if (differing.empty() && unknown.empty() && found.taken_back.empty()) {
    text += "so the record was changed after it was written, or this is a fault of the trainer\n";
  }
  if (!found.taken_back.empty()) {
    text += fmt::format("changes that were taken back are not repeated: {}\n", found.taken_back);
  }
  return text;
}

nlohmann::ordered_json TextOrNull(const std::string& text) {
  return text.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(text);
}

}  // namespace

std::string ReproductionText(const Reproduction& found) {
  if (found.stop_signal != 0) {
    return fmt::format("{}: stopped; {} of {} episodes were trained again, and are equal\n",
                       found.name, found.equal, found.episodes);
  }
  return found.is_equal() ? EqualText(found) : DifferenceText(found) + CausesText(found);
}

nlohmann::ordered_json ReproductionJson(const Reproduction& found) {
  nlohmann::ordered_json json = {{"run", found.name},
                                 {"is_equal", found.is_equal()},
                                 {"episodes", found.episodes},
                                 {"equal_episodes", found.equal},
                                 {"changes", found.changes},
                                 {"is_state_equal", nullptr},
                                 {"difference", nullptr},
                                 {"causes", nlohmann::ordered_json::array()},
                                 {"taken_back", TextOrNull(found.taken_back)}};
  if (found.is_state_equal) json["is_state_equal"] = *found.is_state_equal;
  if (found.stop_signal != 0) json["is_equal"] = nullptr;
  if (!found.differences.empty()) {
    nlohmann::ordered_json values = nlohmann::ordered_json::array();
    for (const ValueDifference& each : found.differences) {
      values.push_back({{"name", each.name}, {"recorded", each.recorded}, {"here", each.here}});
    }
    json["difference"] = {{"episode", found.equal + 1}, {"values", values}};
  }
  for (const CauseComparison& each : found.causes) {
    json["causes"].push_back(
        {{"name", each.name},
         {"recorded", TextOrNull(each.recorded)},
         {"here", each.here},
         {"is_equal", each.recorded.empty() ? nlohmann::ordered_json()
                                            : nlohmann::ordered_json(each.is_equal())}});
  }
  return json;
}

}  // namespace runtime
