#include "runtime/analysis/study/preference_figures.h"

namespace runtime {
namespace {

using Json = nlohmann::ordered_json;

// What is not a number, and what has no end, becomes null.
template <class Value>
Json ToJson(const BeforeAfter<Value>& value) {
  return {{"before", value.before}, {"after", value.after}};
}

Json PreferenceJson(const PreferenceResult& result) {
  const Preference& preference = result.preference;
  return {{"better", preference.better.text()}, {"worse", preference.worse.text()},
          {"is_tie", preference.is_tie},        {"probability", ToJson(result.probability)},
          {"holds", ToJson(result.holds)},      {"is_contradicted", result.is_contradicted},
          {"can_hold", result.can_hold}};
}

Json GainJson(const GainChange& gain) {
  return {{"name", gain.param.name},
          {"unit", gain.param.unit},
          {"scales", gain.param.scales},
          {"before", gain.value.before},
          {"after", gain.value.after},
          {"low", gain.low},
          {"high", gain.high},
          {"sd_of_log", gain.sd},
          {"least", gain.param.least},
          {"greatest", gain.param.greatest},
          {"changes_course", gain.param.changes_course}};
}

Json RunJson(const RunResult& run, const RunReturns& returns) {
  return {{"name", run.run->name},
          {"final_return", ToJson(returns.final)},
          {"mean_return", ToJson(returns.all)},
          {"left_out", returns.left_out ? Json(*returns.left_out) : Json()}};
}

}  // namespace

Json PreferenceFigures(const PreferenceFit& fit) {
  const ExperimentResult& result = *fit.result;
  Json preferences = Json::array();
  for (const PreferenceResult& each : fit.preferences) preferences.push_back(PreferenceJson(each));
  Json gains = Json::array();
  for (const GainChange& gain : fit.gains) gains.push_back(GainJson(gain));
  Json kept = Json::array();
  for (const KeptParam& param : fit.kept) {
    kept.push_back(
        {{"name", param.param.name}, {"value", param.recorded.value}, {"why", param.why}});
  }
  Json terms = Json::array();
  for (size_t i = 0; i < fit.rescored.terms.size(); ++i) {
    terms.push_back(ToJson(fit.rescored.terms[i]));
    terms.back()["name"] = result.experiment->task().terms[i].name;
  }
  Json groups = Json::array();
  for (size_t i = 0; i < fit.rescored.groups.size(); ++i) {
    groups.push_back({{"typical", result.runs[result.groups[i].typical].run->name},
                      {"final_return", ToJson(fit.rescored.groups[i])}});
  }
  Json runs = Json::array();
  for (size_t i = 0; i < result.runs.size(); ++i) {
    runs.push_back(RunJson(result.runs[i], fit.rescored.runs[i]));
  }
  return {{"experiment", result.experiment->name},
          {"is_consistent", fit.is_consistent()},
          {"scale", fit.model.scale},
          {"preferences", std::move(preferences)},
          {"gains", std::move(gains)},
          {"kept", std::move(kept)},
          {"terms", std::move(terms)},
          {"groups", std::move(groups)},
          {"runs", std::move(runs)},
          {"notes", fit.notes}};
}

}  // namespace runtime
