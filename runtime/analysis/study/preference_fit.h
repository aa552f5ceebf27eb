// What a user's preferences between the behaviors of an experiment say of its task's weights.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runtime/analysis/preference/fit.h"
#include "runtime/analysis/preference/preferences_file.h"
#include "runtime/analysis/preference/recorded_params.h"
#include "runtime/analysis/preference/task_params.h"
#include "runtime/analysis/study/rescored.h"
#include "runtime/analysis/study/results.h"

namespace runtime {

struct WeightChange {
  TaskParam param;
  BeforeAfter<double> value;
  double sd = 0;    // of the logarithm of the new value
  double low = 0;   // one deviation below the new value, within the range
  double high = 0;  // one above
};

// A param whose value stays.
struct KeptParam {
  TaskParam param;
  RecordedParam recorded;
  std::string why;
};

struct PreferenceResult {
  Preference preference;
  BeforeAfter<double> probability;
  BeforeAfter<bool> holds;
  bool is_contradicted = false;  // by other preferences
  bool can_hold = true;          // under weights in their ranges that explain most
};

struct PreferenceFit {
  const ExperimentResult* result = nullptr;
  std::vector<PreferenceResult> preferences;
  std::vector<WeightChange> weights;  // at least one
  std::vector<KeptParam> kept;
  Rescored rescored;
  std::vector<std::string> notes;  // what to mind
  PreferenceModel model;
  Fit fit;  // before its values were rounded

  // Whether the preferences are free of contradictions, and weights in their ranges explain them
  // all.
  bool is_consistent() const;
};

// By which factor a weight is expected to change at most, in two cases out of three.
inline constexpr double kExpectedFactor = 2;

// To each experiment the preferences between its runs. Throws UserError, with the place in the
// file, for one about a run that is not there, or about runs of two experiments. `folder`: of the
// study.
std::vector<std::vector<Preference>> PreferencesByExperiment(
    const std::vector<ExperimentResult>& experiments, const std::vector<Preference>& preferences,
    const std::filesystem::path& folder);

// `preferences`: about runs of this experiment; may be none. `params`: of its task. Throws
// UserError where the task has no weight that can be fitted. `result` outlives what is returned.
PreferenceFit FitPreferences(const ExperimentResult& result, const TaskParams& params,
                             const std::vector<Preference>& preferences,
                             double expected_factor = kExpectedFactor);

}  // namespace runtime
