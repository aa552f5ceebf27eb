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

Json WeightJson(const WeightChange& weight) {
  return {{"name", weight.param.name},
          {"unit", weight.param.unit},
          {"scales", weight.param.scales},
          {"before", weight.value.before},
          {"after", weight.value.after},
          {"low", weight.low},
          {"high", weight.high},
          {"sd_of_log", weight.sd},
          {"least", weight.param.least},
          {"greatest", weight.param.greatest},
          {"changes_course", weight.param.changes_course}};
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
  Json weights = Json::array();
  for (const WeightChange& weight : fit.weights) weights.push_back(WeightJson(weight));
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
          {"weights", std::move(weights)},
          {"kept", std::move(kept)},
          {"terms", std::move(terms)},
          {"groups", std::move(groups)},
          {"runs", std::move(runs)},
          {"notes", fit.notes}};
}

}  // namespace runtime
