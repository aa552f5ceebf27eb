#include "runtime/analysis/report/report_timeline.h"

#include <vector>

#include "runtime/analysis/report/base64.h"
#include "runtime/training/run/timeline.h"

namespace runtime {
namespace {

using nlohmann::json;

// The first `frames` samples of `size` values each, and the last one.
template <class Value>
std::vector<Value> Shown(const std::vector<Value>& values, size_t frames, size_t size = 1) {
  const auto first = static_cast<std::ptrdiff_t>(frames * size);
  std::vector<Value> shown(values.begin(), values.begin() + first);
  shown.insert(shown.end(), values.end() - static_cast<std::ptrdiff_t>(size), values.end());
  return shown;
}

}  // namespace

json EncodeTimeline(const Recording& recording, size_t frames, const TaskRecord& task,
                    size_t link_count) {
  if (recording.timeline.empty()) return nullptr;
  const Timeline timeline = ReadTimeline(recording, task, link_count);
  const auto encode = [&](const std::vector<float>& values) {
    return EncodeFloats(Shown(values, frames));
  };
  json encoded = {{"end", timeline.end}, {"returns", encode(timeline.returns)}};
  json& terms = encoded["terms"] = json::array();
  for (size_t i = 0; i < task.terms.size(); ++i) {
    const TermRecord& term = task.terms[i];
    terms.push_back(
        {{"name", term.name}, {"doc", term.doc}, {"values", encode(timeline.terms[i])}});
  }
  json& metrics = encoded["metrics"] = json::array();
  for (size_t i = 0; i < task.metrics.size(); ++i) {
    const CurveRecord& metric = task.metrics[i];
    metrics.push_back({{"name", metric.name},
                       {"unit", metric.unit},
                       {"reduction", metric.reduction},
                       {"doc", metric.doc},
                       {"values", encode(timeline.metrics[i])}});
  }
  if (!task.phases.empty()) {
    json names = json::array();
    for (const PhaseRecord& phase : task.phases) names.push_back(phase.name);
    encoded["phases"] = {{"names", names}, {"values", encode(timeline.phases)}};
  }
  const std::vector<uint8_t> contacts = Shown(timeline.contacts, frames, ContactBytes(link_count));
  encoded["contacts"] = EncodeBase64(std::as_bytes(std::span(contacts)));
  return encoded;
}

}  // namespace runtime
