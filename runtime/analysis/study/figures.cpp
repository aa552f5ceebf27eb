#include "runtime/analysis/study/figures.h"

#include <cmath>

#include "runtime/training/run/estimate.h"
#include "runtime/training/run/run_settings.h"

namespace runtime {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kSecondsInAMinute = 60;

double ValueOf(const std::map<std::string, double>& values, const std::string& name) {
  const auto found = values.find(name);
  return found == values.end() ? kNoNumber : found->second;
}

double FinalReturn(const RunResult& run) { return run.final.episode_return; }

double EpisodesToMost(const RunResult& run) {
  return run.most_learned ? static_cast<double>(run.most_learned->episode) : kNoNumber;
}

double MinutesToMost(const RunResult& run) {
  return run.most_learned ? run.most_learned->cpu_seconds / kSecondsInAMinute : kNoNumber;
}

double Minutes(const RunResult& run) { return run.cpu_seconds / kSecondsInAMinute; }

Json MetricsOf(const std::vector<CurveRecord>& metrics, const std::vector<RunResult>& runs) {
  Json json = Json::array();
  for (const CurveRecord& metric : metrics) {
    Json value = ToJson(EstimateOver(
        runs, [&](const RunResult& run) { return ValueOf(run.final.metrics, metric.name); }));
    json.push_back({{"name", metric.name},
                    {"unit", metric.unit},
                    {"reduction", metric.reduction},
                    {"doc", metric.doc},
                    {"value", std::move(value)}});
  }
  return json;
}

// A term's share is its part of all that was paid and taken: of the sum of the terms' magnitudes.
Json TermsOf(const std::vector<TermRecord>& terms, const std::vector<RunResult>& runs) {
  Json json = Json::array();
  double magnitudes = 0;
  for (const TermRecord& term : terms) {
    const Estimate estimate = EstimateOver(
        runs, [&](const RunResult& run) { return ValueOf(run.final.terms, term.name); });
    if (!std::isnan(estimate.mean)) magnitudes += std::abs(estimate.mean);
    json.push_back({{"name", term.name}, {"doc", term.doc}, {"value", ToJson(estimate)}});
  }
  for (Json& term : json) {
    const Json& mean = term["value"]["mean"];
    term["share"] = magnitudes > 0 ? mean.get<double>() / magnitudes : kNoNumber;
  }
  return json;
}

Json EvaluationsJson(const ExperimentResult& result) {
  Json json = Json::array();
  for (const EvaluationResult& evaluation : EvaluationsOf(result)) {
    json.push_back({{"profile", evaluation.profile},
                    {"learned_return", ToJson(evaluation.learned_return)},
                    {"return", ToJson(evaluation.mean_return)},
                    {"share", evaluation.share()},
                    {"median_share", evaluation.median_share}});
  }
  return json;
}

Json EvaluationsJson(const StudyRun& run) {
  Json json = Json::array();
  for (const PolicyEvaluation& evaluation : run.evaluations) {
    json.push_back({{"profile", evaluation.profile},
                    {"checkpoint_episode", evaluation.checkpoint_episode},
                    {"learned_return", evaluation.learned_return},
                    {"return", evaluation.mean_return},
                    {"share", evaluation.share()}});
  }
  return json;
}

Json RunJson(const RunResult& result) {
  const StudyRun& run = *result.run;
  return {
      {"name", run.name},
      {"seed", run.record.seed},
      {"state", run.is_finished() ? RunStateName(RunState::kFinished) : RunStateName(run.state)},
      {"episodes", run.episodes.size()},
      {"episodes_planned", run.record.episodes_planned},
      {"changes", run.changes},
      {"final_return", FinalReturn(result)},
      {"best_return", result.best_return},
      {"episodes_to_80_percent", EpisodesToMost(result)},
      {"cpu_minutes_to_80_percent", MinutesToMost(result)},
      {"cpu_minutes", Minutes(result)},
      {"metrics", result.final.metrics},
      {"terms", result.final.terms},
      {"evaluations", EvaluationsJson(run)},
      {"group", result.group ? Json(*result.group) : Json()}};
}

// For all runs where their seeds are counted up, as `--runs` does; otherwise for the first run.
std::string CommandOf(const StudyExperiment& experiment) {
  const RunRecord& first = experiment.record();
  uint64_t seed = first.seed;
  for (const StudyRun& run : experiment.runs) {
    if (run.record.seed != seed++) return TrainCommand(first);
  }
  return TrainCommand(first, static_cast<int64_t>(experiment.runs.size()));
}

Json SentencesOf(const BehaviorGroup& group, const ExperimentResult& result,
                 const Sentences& sentences) {
  Json json = Json::array();
  for (const size_t run : group.runs) {
    const auto found = sentences.find(result.runs[run].run->name);
    if (found != sentences.end()) json.push_back(found->second);
  }
  return json;
}

Json GroupJson(size_t index, const ExperimentResult& result, const Sentences& sentences) {
  const BehaviorGroup& group = result.groups[index];
  size_t grouped = 0;
  for (const BehaviorGroup& each : result.groups) grouped += each.runs.size();
  const std::vector<RunResult> members = MembersOf(result, group);
  return {{"name", GroupName(index)},
          {"runs", group.runs},
          {"typical", group.typical},
          {"share", static_cast<double>(group.runs.size()) / static_cast<double>(grouped)},
          {"sentences", SentencesOf(group, result, sentences)},
          {"final_return", ToJson(EstimateOver(members, FinalReturn))},
          {"metrics", MetricsOf(result.experiment->task().metrics, members)}};
}

}  // namespace

Json Figures(const ExperimentResult& result, const Sentences& sentences) {
  const StudyExperiment& experiment = *result.experiment;
  const TaskRecord& task = experiment.task();
  const std::vector<RunResult> settled = SettledRuns(result);
  Json runs = Json::array();
  for (const RunResult& run : result.runs) runs.push_back(RunJson(run));
  Json groups = Json::array();
  for (size_t group = 0; group < result.groups.size(); ++group) {
    groups.push_back(GroupJson(group, result, sentences));
  }
  return {{"name", experiment.name},
          {"task", task.task},
          {"task_file", task.task_file},
          {"task_hash", task.task_hash},
          {"robot", experiment.record().robot},
          {"profile", experiment.record().profile},
          {"version", experiment.record().version},
          {"settings", SettingsJson(experiment.record())},
          {"command", CommandOf(experiment)},
          {"mean_over", result.window},
          {"is_settled", settled.front().run->is_finished()},
          {"final_return", ToJson(EstimateOver(settled, FinalReturn))},
          {"best_return",
           ToJson(EstimateOver(settled, [](const RunResult& run) { return run.best_return; }))},
          {"episodes_to_80_percent", ToJson(EstimateOver(settled, EpisodesToMost))},
          {"cpu_minutes_to_80_percent", ToJson(EstimateOver(settled, MinutesToMost))},
          {"cpu_minutes", ToJson(EstimateOver(settled, Minutes))},
          {"metrics", MetricsOf(task.metrics, settled)},
          {"terms", TermsOf(task.terms, settled)},
          {"evaluations", EvaluationsJson(result)},
          {"groups", std::move(groups)},
          {"runs", std::move(runs)}};
}

Json CurveFigures(const Curves& curves) {
  Json json = {{"episodes", curves.episodes}};
  for (const Estimate& mean : curves.means) {
    json["mean"].push_back(mean.mean);
    json["low"].push_back(mean.low);
    json["high"].push_back(mean.high);
  }
  return json;
}

}  // namespace runtime
