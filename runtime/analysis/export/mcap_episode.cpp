#include "runtime/analysis/export/mcap_episode.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "runtime/analysis/export/foxglove.h"
#include "runtime/analysis/export/mcap_writer.h"

namespace runtime {
namespace {

using nlohmann::json;

constexpr const char* kGoalSchema =
    R"({"type":"object","properties":{"value":{"type":"array","items":{"type":"number"}},)"
    R"("unit":{"type":"string"}}})";
constexpr const char* kEpisodeSchema =
    R"({"type":"object","properties":{"return":{"type":"number"},"end":{"type":"string"},)"
    R"("reason":{"type":"string"},"terms":{"type":"object"},"metrics":{"type":"object"},)"
    R"("logs":{"type":"object"}}})";

uint64_t Nanoseconds(double seconds) { return static_cast<uint64_t>(std::llround(1e9 * seconds)); }

std::string Text(const json& message) {
  return message.dump(-1, ' ', false, json::error_handler_t::replace);
}

// A value that is not a number becomes null.
template <class Named>
json ByName(const std::vector<Named>& names, const std::vector<double>& values) {
  json object = json::object();
  for (size_t i = 0; i < values.size(); ++i) object[names[i].name] = values[i];
  return object;
}

json EpisodeMessage(const TaskRecord& task, const EpisodeRecord& episode) {
  const Evaluation& active = episode.active;
  return {{"return", active.episode_return},
          {"end", active.end_kind},
          {"reason", active.end_reason},
          {"terms", ByName(task.terms, active.terms)},
          {"metrics", ByName(task.metrics, active.metrics)},
          {"logs", ByName(task.logs, active.logs)}};
}

struct Message {
  double time;
  uint16_t channel;
  std::string text;
};

void AddGoals(const TaskRecord& task, const Evaluation& evaluation, McapWriter& writer,
              std::vector<Message>& messages) {
  std::vector<uint16_t> channels;
  for (const GoalRecord& goal : task.goals)
    channels.push_back(writer.AddChannel("/goal/" + goal.name, "taskc.Goal", kGoalSchema));
  for (const GoalDraw& draw : evaluation.goals) {
    const json message = {{"value", draw.value}, {"unit", task.goals[draw.goal].unit}};
    messages.push_back({draw.time, channels[draw.goal], Text(message)});
  }
}

McapWriter::Metadata Description(const RunRecord& run, const TaskRecord& task,
                                 const EpisodeRecord& episode) {
  return {{"task", task.task},
          {"task_hash", task.task_hash},
          {"robot", run.robot},
          {"profile", run.profile},
          {"seed", fmt::to_string(run.seed)},
          {"episode", fmt::to_string(episode.number)},
          {"version", run.version}};
}

}  // namespace

std::string McapOf(const RunRecord& run, const EpisodeRecord& episode, const Motion& motion,
                   const std::vector<robot::Link>& links) {
  const TaskRecord& task = TaskWithId(run, episode.active.task);
  McapWriter writer;
  writer.AddMetadata("run", Description(run, task, episode));
  const uint16_t scene = writer.AddChannel("/robot", "foxglove.SceneUpdate", kSceneUpdateSchema);
  const uint16_t frames = writer.AddChannel("/tf", "foxglove.FrameTransforms", kTransformsSchema);
  std::vector<Message> messages = {{0, scene, Text(SceneUpdate(links))}};
  AddGoals(task, episode.active, writer, messages);
  const uint16_t end = writer.AddChannel("/episode", "taskc.Episode", kEpisodeSchema);
  for (int frame = 0; frame < motion.frame_count(); ++frame) {
    messages.push_back(
        {frame * motion.frame_interval, frames, Text(FrameTransforms(motion, frame, links))});
  }
  messages.push_back({episode.simulated_seconds, end, Text(EpisodeMessage(task, episode))});
  std::ranges::stable_sort(messages, {}, &Message::time);
  for (const Message& message : messages)
    writer.Write(message.channel, Nanoseconds(message.time), message.text);
  return writer.Finish();
}

}  // namespace runtime
