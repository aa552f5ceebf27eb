#include "runtime/analysis/curves/learner_curves.h"

#include <algorithm>
#include <limits>

namespace runtime {
namespace {

double ValueOf(const EpisodeRecord& episode, const std::string& name) {
  const auto found = std::ranges::find(episode.learner, name, &NamedValue::name);
  return found == episode.learner.end() ? std::numeric_limits<double>::quiet_NaN() : found->value;
}

}  // namespace

std::vector<Curve> LearnerCurves(const std::vector<CurveRecord>& curves,
                                 const std::vector<EpisodeRecord>& episodes) {
  std::vector<Curve> shown;
  for (const CurveRecord& record : curves) {
    Curve& curve = shown.emplace_back(record);
    for (const EpisodeRecord& episode : episodes)
      curve.values.push_back(ValueOf(episode, record.name));
  }
  return shown;
}

}  // namespace runtime
