#include "runtime/analysis/report/learner_curves.h"

#include <algorithm>
#include <limits>

#include "runtime/analysis/report/base64.h"

namespace runtime {
namespace {

float ValueOf(const EpisodeRecord& episode, const std::string& name) {
  const auto found = std::ranges::find(episode.learner, name, &NamedValue::name);
  return found == episode.learner.end() ? std::numeric_limits<float>::quiet_NaN()
                                        : static_cast<float>(found->value);
}

}  // namespace

nlohmann::json LearnerCurves(const std::vector<CurveRecord>& curves,
                             const std::vector<EpisodeRecord>& episodes) {
  nlohmann::json encoded = nlohmann::json::array();
  std::vector<float> values(episodes.size());
  for (const CurveRecord& curve : curves) {
    std::ranges::transform(episodes, values.begin(), [&](const EpisodeRecord& episode) {
      return ValueOf(episode, curve.name);
    });
    encoded.push_back({{"name", curve.name},
                       {"unit", curve.unit},
                       {"doc", curve.doc},
                       {"values", EncodeFloats(values)}});
  }
  return encoded;
}

}  // namespace runtime
