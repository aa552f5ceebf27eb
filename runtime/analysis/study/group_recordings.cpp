#include "runtime/analysis/study/group_recordings.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "runtime/analysis/report/base64.h"
#include "runtime/analysis/study/group_strip.h"
#include "runtime/training/run/recorded_poses.h"
#include "runtime/training/run/recorder.h"

namespace runtime {
namespace {

using nlohmann::json;

constexpr size_t kBudget = 6 << 20;    // of all poses and pictures [bytes], before base64
constexpr size_t kMostThinned = 4;     // of so many frames one is kept
constexpr int kPageStripHeight = 208;  // [px]: sharp where the page shows it half as large

struct Replay {
  size_t experiment = 0;
  size_t group = 0;
  size_t members = 0;
  int64_t episode = 0;
  double interval = 0;  // [s]
  size_t frame_size = 0;
  std::vector<float> poses;

  size_t bytes() const { return poses.size() * sizeof(float); }
};

Replay ReadReplay(const ExperimentResult& result, const BehaviorGroup& group, size_t link_count) {
  const FinalRecording final = *ReadFinalRecording(*result.runs[group.typical].run);
  Replay replay;
  replay.members = group.runs.size();
  replay.episode = final.episode;
  replay.interval = final.recording.frame_interval;
  replay.frame_size = link_count * Recorder::kFloatsPerLink;
  replay.poses = ReadPoses(final.recording, link_count);
  return replay;
}

// One frame of `step` is kept.
json Encode(const Replay& replay, size_t step) {
  std::vector<float> kept;
  for (size_t i = 0; i < replay.poses.size(); i += step * replay.frame_size) {
    kept.insert(kept.end(), replay.poses.begin() + static_cast<std::ptrdiff_t>(i),
                replay.poses.begin() + static_cast<std::ptrdiff_t>(i + replay.frame_size));
  }
  return {{"episode", replay.episode},
          {"frames", kept.size() / replay.frame_size},
          {"interval", replay.interval * static_cast<double>(step)},
          {"poses", EncodeFloats(kept)}};
}

}  // namespace

void AddGroupRecordings(const std::vector<ExperimentResult>& results, json& experiments,
                        std::vector<std::string>& notes) {
  std::vector<Replay> replays;
  size_t bytes = 0;
  for (size_t experiment = 0; experiment < results.size(); ++experiment) {
    const ExperimentResult& result = results[experiment];
    for (size_t group = 0; group < result.groups.size(); ++group) {
      Replay& replay = replays.emplace_back(
          ReadReplay(result, result.groups[group], experiments[experiment]["body"].size()));
      replay.experiment = experiment;
      replay.group = group;
      bytes += replay.bytes();
    }
  }
  std::ranges::stable_sort(replays, std::ranges::greater(), &Replay::members);
  const size_t step = std::clamp<size_t>((bytes + kBudget - 1) / kBudget, 1, kMostThinned);
  size_t used = 0;
  size_t left_out = 0;
  for (const Replay& replay : replays) {
    used += replay.bytes() / step;
    if (used > kBudget && &replay != &replays.front()) {
      ++left_out;
      continue;
    }
    const ExperimentResult& result = results[replay.experiment];
    const GroupStrip strip = DrawGroupStrip(result, result.groups[replay.group], kPageStripHeight);
    used += strip.png.size();
    json& group = experiments[replay.experiment]["groups"][replay.group];
    group["recording"] = Encode(replay, step);
    group["strip"] = {{"times", strip.times},
                      {"png", EncodeBase64(std::as_bytes(std::span(strip.png)))}};
  }
  if (left_out == 0) return;
  notes.push_back(
      fmt::format("{} of {} groups have no replay and no pictures here, since the page would "
                  "become too large; their runs' own "
                  "reports have them.",
                  left_out, replays.size()));
}

}  // namespace runtime
