#include "runtime/trainer/results/recorded_episode.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/command_line/command.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

// "3, 50 and 100"
std::string List(std::vector<int64_t> numbers) {
  const int64_t last = numbers.back();
  numbers.pop_back();
  if (numbers.empty()) return fmt::to_string(last);
  return fmt::format("{} and {}", fmt::join(numbers, ", "), last);
}

// "it has 3, 50 and 100"; of many recordings only those before and after `episode`.
std::string WhatIsRecorded(const std::vector<int64_t>& recorded, int64_t episode) {
  constexpr size_t kMostNamed = 12;
  if (recorded.size() <= kMostNamed) return "it has " + List(recorded);
  std::vector<int64_t> named;
  const auto next = std::ranges::lower_bound(recorded, episode);
  if (next != recorded.begin()) named.push_back(*std::prev(next));
  if (next != recorded.end()) named.push_back(*next);
  return fmt::format("of the {} recorded episodes, {} {} nearest", recorded.size(), List(named),
                     named.size() == 1 ? "is" : "are");
}

}  // namespace

RecordedBody ReadBody(const std::filesystem::path& folder, const RunRecord& run) {
  if (run.robot.empty()) {
    throw UserError(
        fmt::format("{}: the run has no robot, and so records no motion", folder.string()));
  }
  RecordedBody body = ParseBody(run.body).value();
  if (body.parts.empty()) {
    throw UserError(
        fmt::format("{}: the run does not say which shapes the robot has", folder.string()));
  }
  return body;
}

int64_t ChooseRecordedEpisode(const std::filesystem::path& folder, const RunDatabase& database,
                              int64_t wanted) {
  std::vector<int64_t> recorded;
  for (const RecordedEpisode& each : database.ReadRecordedEpisodes()) {
    recorded.push_back(each.number);
  }
  if (recorded.empty()) {
    throw UserError(fmt::format(
        "{}: no episode of this run is recorded yet; the first and the last always are, so wait "
        "for them, or continue the run with `trainer resume {}`",
        folder.string(), folder.string()));
  }
  if (wanted == 0) return recorded.back();
  if (std::ranges::binary_search(recorded, wanted)) return wanted;
  throw UserError(fmt::format("{}: episode {} is not recorded; {}", folder.string(), wanted,
                              WhatIsRecorded(recorded, wanted)));
}

void CheckSpan(double from, double to, const Motion& motion) {
  if (!(from <= to)) {
    throw command_line::CallError(fmt::format("--from {} s is after --to {} s", from, to));
  }
  if (from > motion.duration()) {
    throw command_line::CallError(
        fmt::format("--from {} s is after the end of the episode, which is {} s long", from,
                    motion.duration()));
  }
}

Motion ReadRecordedMotion(const std::filesystem::path& folder, const RunDatabase& database,
                          int64_t episode, size_t part_count) {
  try {
    return ReadMotion(*database.ReadRecording(episode), static_cast<int>(part_count));
  } catch (const UserError& error) {
    throw UserError(fmt::format(
        "{}: the recording of episode {} is damaged: {}; choose another one with --episode",
        folder.string(), episode, error.what()));
  }
}

}  // namespace runtime
