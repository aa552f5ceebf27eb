// What came out of the runs of an experiment.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/analysis/study/behavior_groups.h"
#include "runtime/analysis/study/experiments.h"
#include "runtime/analysis/study/learning.h"
#include "runtime/training/run/estimate.h"

namespace runtime {

struct RunResult {
  const StudyRun* run = nullptr;
  FinalMeans final;        // of a run with an episode at least
  double best_return = 0;  // not a number without one
  std::optional<MostLearned> most_learned;
  double cpu_seconds = 0;
  std::optional<size_t> group;  // index
};

struct ExperimentResult {
  const StudyExperiment* experiment = nullptr;
  int64_t window = 1;  // of all means, in episodes
  std::vector<RunResult> runs;
  std::vector<BehaviorGroup> groups;
};

// `experiment` outlives the result. `notes`: gets sentences about what is missing.
ExperimentResult Evaluate(const StudyExperiment& experiment, std::vector<std::string>& notes);

// Sentences that people wrote, by the names of runs (group_notes.h).
using Sentences = std::map<std::string, std::string>;

// All that a study's reports are made of. It refers to itself: can be moved, not copied.
struct StudyResults {
  std::string name;  // of its folder
  Study study;
  std::vector<ExperimentResult> experiments;  // in the order of the study's
  Sentences sentences;
  std::vector<std::string> notes;  // what is missing

  StudyResults() = default;
  StudyResults(StudyResults&&) = default;
  StudyResults& operator=(StudyResults&&) = default;
};

// `runs`: the folders of the study's runs, some of which may be running. Throws UserError where no
// run has an episode yet, and for a mistake in the study's groups.toml.
StudyResults ReadStudyResults(const std::filesystem::path& folder,
                              const std::vector<std::filesystem::path>& runs);

// The mean over runs of what `value` takes from each.
template <class Runs, class Value>
Estimate EstimateOver(const Runs& runs, Value value) {
  std::vector<double> values;
  for (const RunResult& run : runs) values.push_back(value(run));
  return EstimateMean(values);
}

// Those that are finished, since they show what learning led to; all, while none is.
std::vector<RunResult> SettledRuns(const ExperimentResult& result);

// What is left of what runs learned where they act in a profile without learning.
struct EvaluationResult {
  std::string profile;
  Estimate learned_return;  // of the runs that were evaluated there
  Estimate mean_return;     // of the same runs
  double median_share = 0;  // of the runs' own shares; not a number where no run has one
  double share() const { return ShareThatRemains(mean_return.mean, learned_return.mean); }
};

// One for each profile in which a settled run was evaluated, by its name.
std::vector<EvaluationResult> EvaluationsOf(const ExperimentResult& result);

// Of the runs of `group`.
std::vector<RunResult> MembersOf(const ExperimentResult& result, const BehaviorGroup& group);

// The curves of all runs at the same episodes, at most kPoints of them.
struct Curves {
  static constexpr int64_t kPoints = 400;
  std::vector<double> episodes;
  std::vector<std::vector<double>> runs;  // moving averages; shorter where a run is
  std::vector<Estimate> means;            // over the runs that came as far
};

Curves CurvesOf(const ExperimentResult& result);

}  // namespace runtime
