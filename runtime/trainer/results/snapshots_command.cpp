#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/text/print.h"
#include "runtime/analysis/behavior/motion.h"
#include "runtime/analysis/picture/snapshot_strip.h"
#include "runtime/base/user_error.h"
#include "runtime/trainer/commands.h"
#include "runtime/training/run/body_json.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

using command_line::CallError;

struct SnapshotsOptions {
  std::filesystem::path folder;
  std::filesystem::path output;
  int64_t episode = 0;  // 0: the last that was recorded
  StripOptions strip;
  bool json = false;
};

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

int64_t ChooseEpisode(const std::filesystem::path& folder, const RunDatabase& database,
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

Motion ReadEpisode(const std::filesystem::path& folder, const RunDatabase& database,
                   int64_t episode, size_t link_count) {
  try {
    return ReadMotion(*database.ReadRecording(episode), static_cast<int>(link_count));
  } catch (const UserError& error) {
    throw UserError(fmt::format(
        "{}: the recording of episode {} is damaged: {}; choose another one with --episode",
        folder.string(), episode, error.what()));
  }
}

void CheckSpan(const StripOptions& strip, const Motion& motion) {
  if (!(strip.from <= strip.to)) {
    throw CallError(fmt::format("--from {} s is after --to {} s", strip.from, strip.to));
  }
  if (strip.from > motion.duration()) {
    throw CallError(fmt::format("--from {} s is after the end of the episode, which is {} s long",
                                strip.from, motion.duration()));
  }
}

void PrintTimes(const SnapshotsOptions& options, int64_t episode,
                const std::vector<double>& times) {
  if (options.json) {
    const nlohmann::ordered_json json = {
        {"file", options.output.string()}, {"episode", episode}, {"times", times}};
    text::Print("{}\n", json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    text::Print("{}: episode {} at {:.2f} s\n", options.output.string(), episode,
                fmt::join(times, ", "));
  }
}

void Snapshots(const SnapshotsOptions& options) {
  const RunDatabase database = RunDatabase::OpenToRead(options.folder);
  const std::vector<robot::Link> links = ParseBody(database.ReadRun().body).value();
  if (links.empty()) {
    throw UserError(fmt::format("{}: the run does not say which shapes the robot has",
                                options.folder.string()));
  }
  const int64_t episode = ChooseEpisode(options.folder, database, options.episode);
  const Motion motion = ReadEpisode(options.folder, database, episode, links.size());
  CheckSpan(options.strip, motion);
  WriteOutput(options.output, "the pictures", SnapshotStrip(motion, links, options.strip));
  PrintTimes(options, episode, SnapshotTimes(motion, options.strip));
}

}  // namespace

void AddSnapshotsCommand(command_line::Command& program) {
  const auto options = std::make_shared<SnapshotsOptions>();
  command_line::Command& command = program.AddCommand(
      "snapshots", "Draws a recorded episode as a strip of pictures, and prints their times.");
  command.AddOption("RUN", options->folder, "folder of the run").Required();
  command.AddOption("-o,--output", options->output, "PNG file to write")
      .Required()
      .ValueName("FILE");
  command
      .AddOption("--episode", options->episode,
                 "number of a recorded episode; by default the last one")
      .Positive();
  command.AddOption("--count", options->strip.count, "number of pictures")
      .ShowDefault()
      .Range(1, 100);
  command.AddOption("--height", options->strip.height, "height of the strip, in pixels")
      .ShowDefault()
      .Range(16, 4096);
  command.AddOption("--from", options->strip.from, "time of the first picture, in seconds")
      .NonNegative();
  command.AddOption("--to", options->strip.to, "time of the last picture, in seconds")
      .NonNegative();
  command.AddFlag("--json", options->json, "print JSON");
  command.OnRun([options] {
    Snapshots(*options);
    return kSuccess;
  });
}

}  // namespace runtime
