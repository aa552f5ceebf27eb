#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "base/text/print.h"
#include "runtime/analysis/behavior/motion.h"
#include "runtime/analysis/picture/snapshot_strip.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/results/recorded_episode.h"
#include "runtime/training/run/recorded_ground.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

struct SnapshotsOptions {
  std::filesystem::path folder;
  std::filesystem::path output;
  int64_t episode = 0;  // 0: the last that was recorded
  StripOptions strip;
  bool json = false;
};

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
  const RunRecord run = database.ReadRun();
  const RecordedBody body = ReadBody(options.folder, run);
  const int64_t episode = ChooseRecordedEpisode(options.folder, database, options.episode);
  const Motion motion = ReadRecordedMotion(options.folder, database, episode, body.parts.size());
  CheckSpan(options.strip.from, options.strip.to, motion);
  StripOptions strip = options.strip;
  strip.things = body.things;
  strip.ground = GroundOf(run);
  WriteOutput(options.output, "the pictures", SnapshotStrip(motion, body.parts, strip));
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
