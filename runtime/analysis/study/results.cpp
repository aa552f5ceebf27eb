#include "runtime/analysis/study/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "runtime/analysis/study/group_notes.h"
#include "runtime/base/user_error.h"
#include "runtime/training/run/estimate.h"
#include "runtime/training/run/return_statistics.h"

namespace runtime {
namespace {

double BestReturn(const StudyRun& run) {
  ReturnStatistics statistics;
  for (const EpisodeRecord& episode : run.episodes) statistics.Add(episode);
  return std::isfinite(statistics.best()) ? statistics.best() : kNoNumber;
}

RunResult Evaluate(const StudyRun& run, int64_t window) {
  RunResult result;
  result.run = &run;
  result.best_return = BestReturn(run);
  for (const EpisodeRecord& episode : run.episodes) result.cpu_seconds += episode.cpu_seconds;
  result.most_learned = FindMostLearned(run.episodes, window);
  result.final.episode_return = kNoNumber;
  if (!run.episodes.empty()) result.final = MeansAtTheEnd(run.record, run.episodes, window);
  return result;
}

// Every so many episodes, so that at most Curves::kPoints are shown, and the last one.
std::vector<double> ShownEpisodes(int64_t count) {
  std::vector<double> episodes;
  const int64_t stride = (count + Curves::kPoints - 1) / Curves::kPoints;
  for (int64_t episode = count; episode >= 1; episode -= stride) {
    episodes.push_back(static_cast<double>(episode));
  }
  std::ranges::reverse(episodes);
  return episodes;
}

// The name of the folder also where its path ends in a slash or is ".".
std::string NameOf(const std::filesystem::path& folder) {
  const std::filesystem::path whole = std::filesystem::absolute(folder).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

void CheckHasEpisodes(const std::filesystem::path& folder, const Study& study) {
  for (const StudyExperiment& experiment : study.experiments) {
    for (const StudyRun& run : experiment.runs) {
      if (!run.episodes.empty()) return;
    }
  }
  throw UserError(fmt::format("{}: {}", folder.string(),
                              study.notes.empty()
                                  ? "no run has a finished episode yet; wait for the first one, "
                                    "then ask for the report"
                                  : "no run can be read: " + study.notes.front()));
}

}  // namespace

ExperimentResult Evaluate(const StudyExperiment& experiment, std::vector<std::string>& notes) {
  int64_t planned = 0;
  for (const StudyRun& run : experiment.runs) {
    planned = std::max(planned, run.record.episodes_planned);
  }
  ExperimentResult result{&experiment, MeanWindow(planned), {}, GroupBehaviors(experiment, notes)};
  for (const StudyRun& run : experiment.runs) {
    result.runs.push_back(Evaluate(run, result.window));
  }
  for (size_t group = 0; group < result.groups.size(); ++group) {
    for (const size_t run : result.groups[group].runs) result.runs[run].group = group;
  }
  return result;
}

StudyResults ReadStudyResults(const std::filesystem::path& folder,
                              const std::vector<std::filesystem::path>& runs) {
  StudyResults results;
  results.name = NameOf(folder);
  results.study = ReadStudyRuns(folder, runs);
  CheckHasEpisodes(folder, results.study);
  results.sentences = ReadGroupNotes(folder);
  results.notes = results.study.notes;
  for (const StudyExperiment& experiment : results.study.experiments) {
    results.experiments.push_back(Evaluate(experiment, results.notes));
  }
  return results;
}

std::vector<RunResult> SettledRuns(const ExperimentResult& result) {
  std::vector<RunResult> runs;
  std::ranges::copy_if(result.runs, std::back_inserter(runs),
                       [](const RunResult& each) { return each.run->is_finished(); });
  return runs.empty() ? result.runs : runs;
}

std::vector<EvaluationResult> EvaluationsOf(const ExperimentResult& result) {
  struct Returns {
    std::vector<double> learned;
    std::vector<double> mean;
    std::vector<double> shares;
  };
  std::map<std::string, Returns> profiles;
  for (const RunResult& run : SettledRuns(result)) {
    for (const PolicyEvaluation& evaluation : run.run->evaluations) {
      Returns& returns = profiles[evaluation.profile];
      returns.learned.push_back(evaluation.learned_return);
      returns.mean.push_back(evaluation.mean_return);
      returns.shares.push_back(evaluation.share());
    }
  }
  std::vector<EvaluationResult> evaluations;
  for (const auto& [profile, returns] : profiles) {
    evaluations.push_back({profile, EstimateMean(returns.learned), EstimateMean(returns.mean),
                           Median(returns.shares)});
  }
  return evaluations;
}

std::vector<RunResult> MembersOf(const ExperimentResult& result, const BehaviorGroup& group) {
  std::vector<RunResult> members;
  for (const size_t run : group.runs) members.push_back(result.runs[run]);
  return members;
}

Curves CurvesOf(const ExperimentResult& result) {
  size_t longest = 0;
  std::vector<std::vector<double>> averages;
  for (const RunResult& run : result.runs) {
    averages.push_back(MovingAverage(run.run->episodes, result.window));
    longest = std::max(longest, averages.back().size());
  }
  Curves curves{ShownEpisodes(static_cast<int64_t>(longest)), {}, {}};
  curves.runs.resize(averages.size());
  for (const double episode : curves.episodes) {
    const auto index = static_cast<size_t>(episode) - 1;
    std::vector<double> values;
    for (size_t run = 0; run < averages.size(); ++run) {
      if (index >= averages[run].size()) continue;
      values.push_back(averages[run][index]);
      curves.runs[run].push_back(values.back());
    }
    curves.means.push_back(EstimateMean(values));
  }
  return curves;
}

}  // namespace runtime
