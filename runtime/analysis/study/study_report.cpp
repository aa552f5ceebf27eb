#include "runtime/analysis/study/study_report.h"

#include "runtime/analysis/report/agent_modules.h"
#include "runtime/analysis/report/base64.h"
#include "runtime/analysis/report/page.h"
#include "runtime/analysis/study/figures.h"
#include "runtime/analysis/study/group_recordings.h"
#include "runtime/analysis/study/stated_preferences.h"
#include "runtime/analysis/study/value_curves.h"
#include "runtime/training/run/iso_time.h"
#include "runtime/training/run/recorded_ground.h"

namespace runtime {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

template <class Values, class Take>
std::string Encode(const Values& values, Take take) {
  std::vector<float> floats;
  for (const auto& value : values) floats.push_back(static_cast<float>(take(value)));
  return EncodeFloats(floats);
}

std::string Encode(const std::vector<double>& values) {
  return Encode(values, [](double value) { return value; });
}

json Encode(const std::vector<Estimate>& means) {
  return {{"mean", Encode(means, [](const Estimate& e) { return e.mean; })},
          {"low", Encode(means, [](const Estimate& e) { return e.low; })},
          {"high", Encode(means, [](const Estimate& e) { return e.high; })}};
}

json Encode(const std::vector<ValueCurve>& curves) {
  json encoded = json::array();
  for (const ValueCurve& curve : curves) {
    encoded.push_back(Encode(curve.means));
    encoded.back()["name"] = curve.name;
    encoded.back()["unit"] = curve.unit;
  }
  return encoded;
}

// Adds the curves of the experiment and of its runs.
void AddCurves(const ExperimentResult& result, json& experiment) {
  const Curves curves = CurvesOf(result);
  experiment["curve"] = Encode(curves.means);
  experiment["curve"]["episodes"] = Encode(curves.episodes);
  const ValueCurves values = ValueCurvesOf(result, curves.episodes);
  experiment["metricCurves"] = Encode(values.metrics);
  experiment["termCurves"] = Encode(values.terms);
  for (size_t run = 0; run < curves.runs.size(); ++run) {
    experiment["runs"][run]["curve"] = Encode(curves.runs[run]);
  }
}

json PageExperiment(const ExperimentResult& result, const Sentences& sentences) {
  json experiment = Figures(result, sentences);
  const StudyExperiment& runs = *result.experiment;
  AddCurves(result, experiment);
  experiment["modules"] = AgentModules(runs.record().agent);
  experiment["agentText"] = runs.record().agent;
  experiment["source"] = runs.task().sources.front().text;
  experiment["body"] = json::parse(runs.record().body);
  experiment["ground"] = GroundJson(GroundOf(runs.record()));
  return experiment;
}

// Sets `preferences` of each experiment about which there are any.
template <class Json>
void AddPreferences(const StudyResults& results, const std::filesystem::path& folder,
                    Json& experiments, std::vector<std::string>& notes) {
  const std::vector<ordered_json> preferences = StatedPreferences(results, folder, notes);
  for (size_t i = 0; i < preferences.size(); ++i) {
    if (!preferences[i].is_null()) experiments[i]["preferences"] = preferences[i];
  }
}

json PageData(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& runs) {
  const StudyResults results = ReadStudyResults(folder, runs);
  json data = {{"folder", results.name},
               {"path", folder.string()},
               {"title", results.name + " – study"},
               {"madeAt", IsoTimeNow()},
               {"experiments", json::array()}};
  for (const ExperimentResult& result : results.experiments) {
    data["experiments"].push_back(PageExperiment(result, results.sentences));
  }
  std::vector<std::string> notes = results.notes;
  AddPreferences(results, folder, data["experiments"], notes);
  AddGroupRecordings(results.experiments, data["experiments"], notes);
  data["notes"] = notes;
  return data;
}

}  // namespace

ordered_json StudyFigures(const std::filesystem::path& folder,
                          const std::vector<std::filesystem::path>& runs) {
  const StudyResults results = ReadStudyResults(folder, runs);
  ordered_json experiments = ordered_json::array();
  for (const ExperimentResult& result : results.experiments) {
    experiments.push_back(Figures(result, results.sentences));
    experiments.back()["curve"] = CurveFigures(CurvesOf(result));
  }
  std::vector<std::string> notes = results.notes;
  AddPreferences(results, folder, experiments, notes);
  return {{"folder", results.name}, {"experiments", std::move(experiments)}, {"notes", notes}};
}

std::filesystem::path WriteStudyReport(const std::filesystem::path& folder,
                                       const std::vector<std::filesystem::path>& runs,
                                       const std::filesystem::path& output) {
  const std::filesystem::path file = output.empty() ? folder / "report.html" : output;
  const json data = PageData(folder, runs);
  WritePage(file, MakePage(data, PageFolder("study")));
  return file;
}

}  // namespace runtime
