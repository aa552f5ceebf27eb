#include "runtime/analysis/probe/probe_figures.h"

#include <cmath>

#include "runtime/analysis/study/behavior_groups.h"
#include "runtime/training/run/run_settings.h"

namespace runtime {
namespace {

using Json = nlohmann::ordered_json;

// A term's share is its part of all that was paid and taken: of the sum of the terms' magnitudes.
Json TermsOf(const TaskRecord& task, const std::vector<double>& sums) {
  double magnitudes = 0;
  for (const double sum : sums) magnitudes += std::abs(sum);
  Json json = Json::array();
  for (size_t i = 0; i < task.terms.size(); ++i) {
    json.push_back({{"name", task.terms[i].name},
                    {"doc", task.terms[i].doc},
                    {"value", sums[i]},
                    {"share", magnitudes > 0 ? sums[i] / magnitudes : 0}});
  }
  return json;
}

Json MetricsOf(const TaskRecord& task, const std::vector<double>& values) {
  Json json = Json::array();
  for (size_t i = 0; i < task.metrics.size(); ++i) {
    const CurveRecord& metric = task.metrics[i];
    json.push_back(
        {{"name", metric.name}, {"unit", metric.unit}, {"doc", metric.doc}, {"value", values[i]}});
  }
  return json;
}

Json FindJson(const Find& find, size_t index, const TaskRecord& task) {
  const Evaluation& active = find.episode.active;
  const std::optional<double> frequency = find.frequency();
  return {{"name", GroupName(index)},
          {"run", find.run},
          {"seed", find.seed},
          {"episode", find.episode.number},
          {"return", active.episode_return},
          {"seconds", find.episode.simulated_seconds},
          {"end", {{"kind", active.end_kind}, {"reason", active.end_reason}}},
          {"searches", find.searches},
          {"frequency", frequency ? Json(*frequency) : Json()},
          {"greatest_speed", find.extremes.speed},
          {"greatest_height", find.extremes.height},
          {"beyond", find.beyond},
          {"terms", TermsOf(task, active.terms)},
          {"metrics", MetricsOf(task, active.metrics)}};
}

}  // namespace

Json ProbeFigures(const ProbeResults& results) {
  const TaskRecord& task = results.task();
  Json finds = Json::array();
  for (size_t i = 0; i < results.finds.size(); ++i) {
    finds.push_back(FindJson(results.finds[i], i, task));
  }
  return {{"folder", results.folder},
          {"task", task.task},
          {"task_file", task.task_file},
          {"task_hash", task.task_hash},
          {"robot", results.record.robot},
          {"profile", results.record.profile},
          {"version", results.record.version},
          {"settings", SettingsJson(results.record)},
          {"searches", results.searches},
          {"episodes", results.episodes},
          {"diverged", results.diverged},
          {"cpu_minutes", results.cpu_seconds / 60},
          {"finds", std::move(finds)},
          {"left_out", results.left_out},
          {"notes", results.notes}};
}

}  // namespace runtime
