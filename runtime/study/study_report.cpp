#include "runtime/study/study_report.h"

#include <fmt/format.h>

#include <map>

#include "runtime/module/user_error.h"
#include "runtime/report/agent_modules.h"
#include "runtime/report/base64.h"
#include "runtime/report/page.h"
#include "runtime/run/iso_time.h"
#include "runtime/study/figures.h"
#include "runtime/study/group_notes.h"
#include "runtime/study/group_recordings.h"

namespace runtime {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

// The name of the folder also where its path ends in a slash or is ".".
std::string NameOf(const std::filesystem::path& folder) {
  const std::filesystem::path whole = std::filesystem::absolute(folder).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

Study ReadStudy(const std::filesystem::path& folder,
                const std::vector<std::filesystem::path>& runs) {
  Study study = ReadStudyRuns(folder, runs);
  for (const StudyExperiment& experiment : study.experiments) {
    for (const StudyRun& run : experiment.runs) {
      if (!run.episodes.empty()) return study;
    }
  }
  throw UserError(fmt::format("{}: {}", folder.string(),
                              study.notes.empty()
                                  ? "no run has a finished episode yet; wait for the first one, "
                                    "then ask for the report"
                                  : "no run can be read: " + study.notes.front()));
}

template <class Values, class Take>
std::string Encode(const Values& values, Take take) {
  std::vector<float> floats;
  for (const auto& value : values) floats.push_back(static_cast<float>(take(value)));
  return EncodeFloats(floats);
}

std::string Encode(const std::vector<double>& values) {
  return Encode(values, [](double value) { return value; });
}

// Adds the curves of the experiment and of its runs.
void AddCurves(const Curves& curves, json& experiment) {
  experiment["curve"] = {{"episodes", Encode(curves.episodes)},
                         {"mean", Encode(curves.means, [](const Estimate& e) { return e.mean; })},
                         {"low", Encode(curves.means, [](const Estimate& e) { return e.low; })},
                         {"high", Encode(curves.means, [](const Estimate& e) { return e.high; })}};
  for (size_t run = 0; run < curves.runs.size(); ++run) {
    experiment["runs"][run]["curve"] = Encode(curves.runs[run]);
  }
}

json PageExperiment(const ExperimentResult& result, const Sentences& sentences) {
  json experiment = Figures(result, sentences);
  const StudyExperiment& runs = *result.experiment;
  AddCurves(CurvesOf(result), experiment);
  experiment["modules"] = AgentModules(runs.record().agent);
  experiment["agentText"] = runs.record().agent;
  const std::vector<SourceRecord>& sources = runs.task().sources;
  experiment["source"] = sources.empty() ? "" : sources.front().text;
  const json body = json::parse(runs.record().body, nullptr, false);
  experiment["body"] = body.is_array() ? body : json::array();
  return experiment;
}

json PageData(const std::filesystem::path& folder, const Study& study) {
  const Sentences sentences = ReadGroupNotes(folder);
  json data = {{"folder", NameOf(folder)},
               {"title", NameOf(folder) + " – study"},
               {"madeAt", IsoTimeNow()},
               {"experiments", json::array()}};
  std::vector<std::string> notes = study.notes;
  std::vector<ExperimentResult> results;
  for (const StudyExperiment& experiment : study.experiments) {
    results.push_back(Evaluate(experiment, notes));
    data["experiments"].push_back(PageExperiment(results.back(), sentences));
  }
  AddGroupRecordings(results, data["experiments"], notes);
  data["notes"] = notes;
  return data;
}

}  // namespace

ordered_json StudyFigures(const std::filesystem::path& folder,
                          const std::vector<std::filesystem::path>& runs) {
  const Study study = ReadStudy(folder, runs);
  const Sentences sentences = ReadGroupNotes(folder);
  std::vector<std::string> notes = study.notes;
  ordered_json experiments = ordered_json::array();
  for (const StudyExperiment& experiment : study.experiments) {
    const ExperimentResult result = Evaluate(experiment, notes);
    experiments.push_back(Figures(result, sentences));
    experiments.back()["curve"] = CurveFigures(CurvesOf(result));
  }
  return {{"folder", NameOf(folder)}, {"experiments", std::move(experiments)}, {"notes", notes}};
}

std::filesystem::path WriteStudyReport(const std::filesystem::path& folder,
                                       const std::vector<std::filesystem::path>& runs,
                                       const std::filesystem::path& output) {
  const std::filesystem::path file = output.empty() ? folder / "report.html" : output;
  const json data = PageData(folder, ReadStudy(folder, runs));
  WritePage(file, MakePage(data, PageFolder("study")));
  return file;
}

}  // namespace runtime
