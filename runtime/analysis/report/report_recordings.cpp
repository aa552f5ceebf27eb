#include "runtime/analysis/report/report_recordings.h"

#include <fmt/format.h>

#include <optional>

#include "runtime/analysis/report/base64.h"
#include "runtime/analysis/report/choose_recordings.h"
#include "runtime/analysis/report/goals_told.h"
#include "runtime/analysis/report/report_timeline.h"
#include "runtime/base/user_error.h"
#include "runtime/training/run/recorded_ground.h"
#include "runtime/training/run/recorded_poses.h"
#include "runtime/training/run/recorder.h"

namespace runtime {
namespace {

using nlohmann::json;

constexpr size_t kBudget = 8 << 20;   // of all recordings in the page [bytes]
constexpr size_t kMaximumCount = 40;  // more marks than that hide the learning curve
constexpr double kBase64Growth = 4. / 3;

// What can be replayed: recordings of the episodes that the page shows.
std::vector<RecordingEntry> ListRecordings(const RunDatabase& database,
                                           const std::vector<EpisodeRecord>& episodes) {
  std::vector<RecordingEntry> entries;
  for (const RecordedEpisode& each : database.ReadRecordedEpisodes()) {
    if (each.number > episodes.back().number) break;
    const EpisodeRecord& episode = episodes[static_cast<size_t>(each.number - 1)];
    entries.push_back(
        {each.number, episode.active.episode_return, static_cast<size_t>(each.frames)});
  }
  return entries;
}

// The sizes in the page instead of the numbers of frames.
std::vector<RecordingEntry> WithSizes(std::vector<RecordingEntry> entries, size_t frame_size) {
  for (RecordingEntry& entry : entries) {
    const auto bytes = static_cast<double>(entry.size * frame_size * sizeof(float));
    entry.size = static_cast<size_t>(kBase64Growth * bytes);
  }
  return entries;
}

// What is shown beside the motion: its task, how it ended, what it was told and what it paid. A
// timeline that is damaged is left out with a note.
void AddCourse(const Recording& stored, const RunRecord& run, const EpisodeRecord& episode,
               size_t link_count, json& recording, json& notes) {
  const Evaluation& active = episode.active;
  const TaskRecord& task = TaskWithId(run, active.task);
  recording["episode"] = episode.number;
  recording["task"] = active.task - 1;
  recording["end"] = {{"kind", active.end_kind}, {"reason", active.end_reason}};
  recording["goals"] = GoalsTold(task, active);
  try {
    const auto frames = recording["frames"].get<size_t>();
    recording["timeline"] = EncodeTimeline(stored, frames, task, link_count);
  } catch (const UserError& error) {
    recording["timeline"] = nullptr;
    notes.push_back(fmt::format("What episode {} paid from step to step is left out: {}.",
                                episode.number, error.what()));
  }
}

}  // namespace

json EncodeRecording(const Recording& recording, size_t link_count) {
  const std::vector<float> poses = ReadPoses(recording, link_count);
  return {{"frames", poses.size() / (link_count * Recorder::kFloatsPerLink)},
          {"interval", recording.frame_interval},
          {"poses", EncodeFloats(poses)}};
}

void AddRecordings(const RunDatabase& database, const RunRecord& run,
                   const std::vector<EpisodeRecord>& episodes, json& data) {
  data["body"] = json::parse(run.body);
  data["ground"] = GroundJson(GroundOf(run));
  json& notes = data["notes"] = json::array();
  json& recordings = data["recordings"] = json::array();
  const size_t frame_size = data["body"].size() * Recorder::kFloatsPerLink;
  const std::vector<RecordingEntry> entries =
      WithSizes(ListRecordings(database, episodes), frame_size);
  if (entries.empty()) return;
  if (frame_size == 0) {
    notes.emplace_back("The run does not record the robot's shapes, so there is no replay.");
    return;
  }
  const std::vector<size_t> chosen = ChooseRecordings(entries, kBudget, kMaximumCount);
  for (const size_t index : chosen) {
    const int64_t episode = entries[index].episode;
    try {
      const std::optional<Recording> stored = database.ReadRecording(episode);
      if (!stored) continue;  // deleted since it was listed
      json recording = EncodeRecording(*stored, data["body"].size());
      AddCourse(*stored, run, episodes[static_cast<size_t>(episode - 1)], data["body"].size(),
                recording, notes);
      recording["best"] = index == BestRecording(entries);
      recordings.push_back(std::move(recording));
    } catch (const UserError& error) {
      notes.push_back(
          fmt::format("The recording of episode {} is left out: {}.", episode, error.what()));
    }
  }
  if (chosen.size() < entries.size()) {
    notes.push_back(fmt::format(
        "{} of {} recorded episodes can be replayed here; the others would make the page "
        "too large and stay in the run's database.",
        chosen.size(), entries.size()));
  }
}

}  // namespace runtime
