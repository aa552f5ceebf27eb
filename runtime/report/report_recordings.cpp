#include "runtime/report/report_recordings.h"

#include <fmt/format.h>

#include <optional>

#include "runtime/module/user_error.h"
#include "runtime/report/base64.h"
#include "runtime/report/choose_recordings.h"
#include "runtime/run/recorded_poses.h"
#include "runtime/run/recorder.h"
#include "runtime/run/sqlite.h"

namespace runtime {
namespace {

using nlohmann::json;

constexpr size_t kBudget = 8 << 20;   // of all recordings in the page [bytes]
constexpr size_t kMaximumCount = 40;  // more marks than that hide the learning curve
constexpr double kBase64Growth = 4. / 3;

// The links' shapes as the run has noted them (body_json.h); empty where it has not.
json BodyOf(const std::string& text) {
  json body = json::parse(text, nullptr, false);
  return body.is_array() ? body : json::array();
}

// What can be replayed: recordings of the episodes that the page shows.
std::vector<RecordingEntry> ListRecordings(const std::filesystem::path& run_dir,
                                           const std::vector<EpisodeRecord>& episodes) {
  const SqliteDatabase database(run_dir / "run.db", SqliteAccess::kRead);
  SqliteStatement query(database,
                        "SELECT episode, return, frames FROM recording JOIN evaluation "
                        "USING (episode) WHERE is_active ORDER BY episode",
                        "list the recordings");
  std::vector<RecordingEntry> entries;
  while (query.Step() && query.Integer(0) <= episodes.back().number) {
    entries.push_back({query.Integer(0), query.Real(1), static_cast<size_t>(query.Integer(2))});
  }
  return entries;
}

// Throws UserError where the recording is damaged.
json EncodeRecording(const Recording& recording, size_t link_count) {
  const std::vector<float> poses = ReadPoses(recording, link_count);
  return {{"frames", poses.size() / (link_count * Recorder::kFloatsPerLink)},
          {"interval", recording.frame_interval},
          {"poses", EncodeFloats(poses)}};
}

// The sizes in the page instead of the numbers of frames.
std::vector<RecordingEntry> WithSizes(std::vector<RecordingEntry> entries, size_t frame_size) {
  for (RecordingEntry& entry : entries) {
    const auto bytes = static_cast<double>(entry.size * frame_size * sizeof(float));
    entry.size = static_cast<size_t>(kBase64Growth * bytes);
  }
  return entries;
}

}  // namespace

void AddRecordings(const std::filesystem::path& run_dir, const RunDatabase& database,
                   const std::string& body, const std::vector<EpisodeRecord>& episodes,
                   json& data) {
  data["body"] = BodyOf(body);
  json& notes = data["notes"] = json::array();
  json& recordings = data["recordings"] = json::array();
  const size_t frame_size = data["body"].size() * Recorder::kFloatsPerLink;
  const std::vector<RecordingEntry> entries =
      WithSizes(ListRecordings(run_dir, episodes), frame_size);
  if (entries.empty()) return;
  if (frame_size == 0) {
    notes.push_back("The run does not say which shapes the robot has, so there is no replay.");
    return;
  }
  const std::vector<size_t> chosen = ChooseRecordings(entries, kBudget, kMaximumCount);
  for (const size_t index : chosen) {
    const int64_t episode = entries[index].episode;
    const std::optional<Recording> stored = database.ReadRecording(episode);
    if (!stored) continue;  // deleted since it was listed
    try {
      json recording = EncodeRecording(*stored, data["body"].size());
      recording["episode"] = episode;
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
