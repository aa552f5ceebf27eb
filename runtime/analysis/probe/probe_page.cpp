#include "runtime/analysis/probe/probe_page.h"

#include <algorithm>
#include <optional>
#include <span>

#include "runtime/analysis/picture/snapshot_strip.h"
#include "runtime/analysis/probe/probe_figures.h"
#include "runtime/analysis/report/agent_modules.h"
#include "runtime/analysis/report/base64.h"
#include "runtime/analysis/report/page.h"
#include "runtime/analysis/report/report_recordings.h"
#include "runtime/training/learning/parametric_motion.h"
#include "runtime/training/run/body_json.h"
#include "runtime/training/run/iso_time.h"
#include "runtime/training/run/recorded_ground.h"

namespace runtime {
namespace {

using nlohmann::json;

constexpr int kStripHeight = 208;  // [px]: sharp where the page shows it half as large

// What all pictures of a run have in common.
struct Scenery {
  RecordedBody body;
  world::Ground ground;
};

json Strip(const Motion& motion, const Scenery& scenery, StripOptions options) {
  options.things = scenery.body.things;
  options.ground = scenery.ground;
  const std::string png = SnapshotStrip(motion, scenery.body.parts, options);
  return {{"times", SnapshotTimes(motion, options)},
          {"png", EncodeBase64(std::as_bytes(std::span(png)))}};
}

bool IsRepeated(const json& modules) {
  return std::ranges::any_of(modules, [](const json& module) {
    return module.value("kind", json()) == ParametricMotion::kPeriodic;
  });
}

// Pictures all over an episode do not show what happens several times a second.
std::optional<StripOptions> OneRepetition(const Find& find, const json& modules) {
  const double seconds = find.episode.simulated_seconds;
  const double period = 1 / find.frequency().value_or(0);
  if (!IsRepeated(modules) || !(2 * period < seconds)) return std::nullopt;
  const double from = seconds / 2;
  return StripOptions{.height = kStripHeight, .from = from, .to = from + period};
}

// Sets the pictures and the replay of a find.
void AddMotion(const Find& find, const Scenery& scenery, json& data) {
  const size_t parts = scenery.body.parts.size();
  const Motion motion = ReadMotion(find.recording, static_cast<int>(parts));
  data["modules"] = AgentModules(find.agent);
  data["strip"] = Strip(motion, scenery, {.height = kStripHeight});
  const auto repetition = OneRepetition(find, data["modules"]);
  data["repetition"] = repetition ? Strip(motion, scenery, *repetition) : json();
  data["recording"] = EncodeRecording(find.recording, parts);
  data["recording"]["episode"] = find.episode.number;
}

}  // namespace

void WriteProbePage(const ProbeResults& results, const std::filesystem::path& file) {
  json data = ProbeFigures(results);
  const TaskRecord& task = results.task();
  data["title"] = task.task + " – what it pays for";
  data["madeAt"] = IsoTimeNow();
  data["source"] = task.sources.front().text;
  data["body"] = json::parse(results.record.body);
  data["ground"] = GroundJson(GroundOf(results.record));
  const Scenery scenery{ParseBody(results.record.body).value(), GroundOf(results.record)};
  for (size_t i = 0; i < results.finds.size(); ++i) {
    AddMotion(results.finds[i], scenery, data["finds"][i]);
  }
  WritePage(file, MakePage(data, PageFolder("probe")));
}

}  // namespace runtime
