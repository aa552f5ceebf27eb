#include "runtime/training/run/timeline.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <span>
#include <string>

#include "runtime/base/user_error.h"
#include "runtime/training/run/compression.h"

namespace runtime {
namespace {

static_assert(std::endian::native == std::endian::little, "timelines are little-endian");

// Calls `action` for the values of each column, in their order.
template <class AnyTimeline, class Action>
void ForEachColumn(AnyTimeline& timeline, Action action) {
  action(timeline.returns);
  for (auto& term : timeline.terms) action(term);
  for (auto& metric : timeline.metrics) action(metric);
  action(timeline.phases);
}

template <class Value>
void Append(std::string& bytes, std::span<const Value> values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

// Takes values off the front of `bytes`, which has enough of them.
template <class Value>
void Take(std::string_view& bytes, std::span<Value> values) {
  if (values.empty()) return;
  std::memcpy(values.data(), bytes.data(), values.size_bytes());
  bytes.remove_prefix(values.size_bytes());
}

}  // namespace

std::string PackTimeline(const Timeline& timeline) {
  std::string bytes;
  Append(bytes, std::span(&timeline.end, 1));
  ForEachColumn(timeline, [&](const std::vector<float>& values) { Append<float>(bytes, values); });
  Append<uint8_t>(bytes, timeline.contacts);
  return Compress(std::as_bytes(std::span(bytes)));
}

Timeline ReadTimeline(const Recording& recording, const TaskRecord& task, size_t link_count) {
  const std::string bytes = Decompress(recording.timeline, "its timeline");
  const size_t samples = static_cast<size_t>(recording.frames) + 1;
  Timeline timeline;
  timeline.returns.resize(samples);
  timeline.terms.assign(task.terms.size(), std::vector<float>(samples));
  timeline.metrics.assign(task.metrics.size(), std::vector<float>(samples));
  if (!task.phases.empty()) timeline.phases.resize(samples);
  timeline.contacts.resize(samples * ContactBytes(link_count));
  size_t size = sizeof(timeline.end) + timeline.contacts.size();
  ForEachColumn(timeline,
                [&](std::vector<float>& values) { size += values.size() * sizeof(float); });
  if (bytes.size() != size) throw UserError("its timeline does not fit the task and the robot");
  std::string_view rest = bytes;
  Take(rest, std::span(&timeline.end, 1));
  ForEachColumn(timeline, [&](std::vector<float>& values) { Take<float>(rest, values); });
  Take<uint8_t>(rest, timeline.contacts);
  const double last_frame = static_cast<double>(recording.frames - 1) * recording.frame_interval;
  if (!(timeline.end >= last_frame - 1e-6) || !std::isfinite(timeline.end)) {
    throw UserError("its timeline ends before its last frame");
  }
  return timeline;
}

}  // namespace runtime
