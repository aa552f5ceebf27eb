#include "runtime/analysis/study/rescored.h"

#include <algorithm>

#include "runtime/training/run/estimate.h"

namespace runtime {
namespace {

using Values = std::vector<double>;

BeforeAfter<double> Means(const BeforeAfter<Values>& values) {
  return {EstimateMean(values.before).mean, EstimateMean(values.after).mean};
}

// The return as it was recorded, and what the terms pay more: so that nothing is lost that was paid
// outside of any term.
double NewReturn(const Evaluation& evaluation, const Eigen::VectorXd& factors) {
  double value = evaluation.episode_return;
  for (size_t i = 0; i < evaluation.terms.size(); ++i) {
    value += evaluation.terms[i] * (factors[static_cast<Eigen::Index>(i)] - 1);
  }
  return value;
}

RunReturns RescoreRun(const StudyRun& run, int64_t window, const Eigen::VectorXd& factors) {
  BeforeAfter<Values> all;
  for (const EpisodeRecord& episode : run.episodes) {
    all.before.push_back(episode.active.episode_return);
    all.after.push_back(NewReturn(episode.active, factors));
  }
  const auto last = [&](const Values& values) {
    const size_t count = std::min(values.size(), static_cast<size_t>(window));
    return Values(values.end() - static_cast<std::ptrdiff_t>(count), values.end());
  };
  return {std::nullopt, Means({last(all.before), last(all.after)}), Means(all)};
}

BeforeAfter<double> RescoreGroup(const BehaviorGroup& group, const std::vector<RunReturns>& runs) {
  BeforeAfter<Values> finals;
  for (const size_t run : group.runs) {
    finals.before.push_back(runs[run].final.before);
    finals.after.push_back(runs[run].final.after);
  }
  return Means(finals);
}

// Its mean at the end of the runs that count.
double MeanOfTerm(const ExperimentResult& result, const std::vector<RunReturns>& runs,
                  const std::string& term) {
  Values sums;
  for (size_t i = 0; i < runs.size(); ++i) {
    const RunResult& run = result.runs[i];
    const auto sum = run.final.terms.find(term);
    if (runs[i].left_out || !run.run->is_finished() || sum == run.final.terms.end()) continue;
    sums.push_back(sum->second);
  }
  return EstimateMean(sums).mean;
}

}  // namespace

Rescored Rescore(const ExperimentResult& result, const Eigen::VectorXd& factors,
                 const std::vector<std::optional<std::string>>& left_out) {
  Rescored rescored;
  for (size_t i = 0; i < result.runs.size(); ++i) {
    rescored.runs.push_back(
        left_out[i] ? RunReturns{left_out[i], {kNoNumber, kNoNumber}, {kNoNumber, kNoNumber}}
                    : RescoreRun(*result.runs[i].run, result.window, factors));
  }
  for (const BehaviorGroup& group : result.groups) {
    rescored.groups.push_back(RescoreGroup(group, rescored.runs));
  }
  const std::vector<TermRecord>& terms = result.experiment->task().terms;
  for (size_t i = 0; i < terms.size(); ++i) {
    const double before = MeanOfTerm(result, rescored.runs, terms[i].name);
    rescored.terms.push_back({before, before * factors[static_cast<Eigen::Index>(i)]});
  }
  return rescored;
}

}  // namespace runtime
