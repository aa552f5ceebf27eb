#include "tests/runtime/analysis/report/sample_timeline.h"

#include <cmath>
#include <numeric>

#include "runtime/training/run/timeline.h"

namespace runtime {
namespace {

constexpr size_t kLinks = 18;

// How a sum is spread over the samples: in waves, or, of a `rare` one, at some of them.
std::vector<double> Weights(size_t samples, double frequency, bool is_rare) {
  std::vector<double> weights(samples);
  for (size_t i = 0; i < samples; ++i) {
    const double wave = 1 + 0.9 * std::sin(frequency * static_cast<double>(i));
    weights[i] = is_rare ? static_cast<double>(i % 173 == 90) : wave;
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.);
  for (double& weight : weights) weight /= sum;
  return weights;
}

}  // namespace

std::string SampleTimeline(const Recording& recording, const EpisodeRecord& episode,
                           const TaskRecord& task) {
  const auto samples = static_cast<size_t>(recording.frames) + 1;
  const Evaluation& active = episode.active;
  Timeline timeline;
  timeline.end = static_cast<double>(recording.frames - 1) * recording.frame_interval + 0.005;
  timeline.returns.resize(samples);
  for (size_t term = 0; term < task.terms.size(); ++term) {
    std::vector<float>& paid = timeline.terms.emplace_back();
    const bool is_rare = task.terms[term].name == "fall" && samples > 90;
    for (const double weight : Weights(samples, 0.06 + 0.05 * static_cast<double>(term), is_rare)) {
      paid.push_back(static_cast<float>(weight * active.terms[term]));
      timeline.returns[paid.size() - 1] += paid.back();
    }
  }
  for (const double last : active.metrics) {
    std::vector<float>& values = timeline.metrics.emplace_back();
    for (size_t i = 0; i < samples; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(samples - 1);
      values.push_back(static_cast<float>(part * last));
    }
  }
  for (size_t i = 0; i < samples; ++i) {
    const bool is_left = i / 25 % 2 == 0;  // hands and feet by turns
    const uint8_t hand = is_left ? 1 << 4 : 1 << 7;
    const uint8_t foot = is_left ? 1 << 4 : 0;
    timeline.contacts.insert(timeline.contacts.end(),
                             {hand, foot, static_cast<uint8_t>(is_left ? 0 : 1 << 1)});
  }
  static_assert(ContactBytes(kLinks) == 3);
  return PackTimeline(timeline);
}

}  // namespace runtime
