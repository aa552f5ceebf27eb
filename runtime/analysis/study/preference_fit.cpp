#include "runtime/analysis/study/preference_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "runtime/analysis/preference/contradictions.h"
#include "runtime/analysis/preference/weight_value.h"
#include "runtime/analysis/study/compared_behavior.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

// Of a weight whose range says nothing, or includes zero.
constexpr double kMostChange = 1000;
// A weight that changes less stays as it is.
constexpr double kUnchanged = 1e-6;

Eigen::Index IndexOf(size_t index) { return static_cast<Eigen::Index>(index); }

class Fitter {
 public:
  Fitter(const ExperimentResult& result, const TaskParams& params, double expected_factor)
      : result_(result), terms_(result.experiment->task().terms) {
    fit_.result = &result;
    fit_.model.prior_sd = std::log(expected_factor);
    SortParams(params);
    SetBounds();
    for (const RunResult& run : result.runs) left_out_.push_back(WhyIncomparable(*run.run));
  }

  PreferenceFit Fit(const std::vector<Preference>& preferences) {
    for (const Preference& preference : preferences) AddPreference(preference);
    SetScale();
    fit_.fit = FitWeights(fit_.model);
    TakeValues();
    Judge();
    fit_.rescored = Rescore(result_, TermFactors(fit_.model.loads, x_), left_out_);
    AddNotes();
    return std::move(fit_);
  }

 private:
  void SortParams(const TaskParams& params) {
    const std::map<std::string, RecordedParam> recorded =
        RecordedParams(result_.experiment->record());
    for (const TaskParam& param : params.params) {
      const auto found = recorded.find(param.name);
      const RecordedParam value =
          found == recorded.end() ? RecordedParam{param.initial} : found->second;
      if (param.scales.empty()) {
        fit_.kept.push_back({param, value, "it is not a weight of a reward term"});
      } else if (value.value == 0) {
        fit_.kept.push_back(
            {param, value, "it was 0 in these runs, so that the term it scales was not recorded"});
      } else {
        fit_.weights.push_back({param, {value.value, value.value}});
        kinds_.push_back(value.kind);
      }
    }
    if (fit_.weights.empty()) {
      throw UserError(fmt::format(
          "{}: no param of the task {} is a weight that can be fitted; a weight is a param "
          "that multiplies everything that a reward term pays: `reward fall = -fall_penalty`",
          result_.experiment->name, result_.experiment->task().task));
    }
  }

  void SetBounds() {
    const Eigen::Index weights = IndexOf(fit_.weights.size());
    fit_.model.loads = Eigen::MatrixXd::Zero(IndexOf(terms_.size()), weights);
    fit_.model.lower.resize(weights);
    fit_.model.upper.resize(weights);
    for (size_t weight = 0; weight < fit_.weights.size(); ++weight) {
      const TaskParam& param = fit_.weights[weight].param;
      for (size_t term = 0; term < terms_.size(); ++term) {
        const bool is_scaled = std::ranges::count(param.scales, terms_[term].name) > 0;
        fit_.model.loads(IndexOf(term), IndexOf(weight)) = is_scaled ? 1 : 0;
      }
      const double before = fit_.weights[weight].value.before;
      const auto [low, high] = std::minmax({param.least / before, param.greatest / before});
      fit_.model.lower[IndexOf(weight)] = std::log(std::clamp(low, 1 / kMostChange, 1.));
      fit_.model.upper[IndexOf(weight)] = std::log(std::clamp(high, 1., kMostChange));
    }
  }

  const Eigen::VectorXd& SumsOf(const BehaviorName& behavior) {
    const auto found = sums_.find(behavior);
    if (found != sums_.end()) return found->second;
    const size_t run = FindRun(result_, behavior.run).value();
    if (left_out_[run]) {
      throw UserError(fmt::format("{} does not count: {}", behavior.run, *left_out_[run]));
    }
    return sums_.emplace(behavior, TermSums(result_.runs[run], behavior)).first->second;
  }

  // One that cannot be used is left out with a note.
  void AddPreference(const Preference& preference) {
    try {
      fit_.model.comparisons.push_back(
          {SumsOf(preference.better) - SumsOf(preference.worse), preference.is_tie ? 0.5 : 1});
      fit_.preferences.push_back({preference, {}, {}});
    } catch (const UserError& error) {
      fit_.notes.push_back(fmt::format("`{}` is left out: {}.", preference.text(), error.what()));
    }
  }

  // How far returns of these behaviors are apart, if nothing is said of how the terms go together.
  void SetScale() {
    std::map<BehaviorName, Eigen::VectorXd> behaviors = sums_;
    for (size_t i = 0; i < result_.runs.size(); ++i) {
      const StudyRun& run = *result_.runs[i].run;
      if (left_out_[i] || !run.is_finished()) continue;
      const BehaviorName name{run.name, std::nullopt};
      behaviors.emplace(name, TermSums(result_.runs[i], name));
    }
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(IndexOf(terms_.size()));
    for (const auto& [name, sums] : behaviors) mean += sums / static_cast<double>(behaviors.size());
    double variance = 0;
    for (const auto& [name, sums] : behaviors) {
      variance += (sums - mean).squaredNorm() / static_cast<double>(behaviors.size());
    }
    fit_.model.scale = variance > 0 ? std::sqrt(variance) : 1;
  }

  void TakeValues() {
    x_ = Eigen::VectorXd::Zero(fit_.fit.x.size());
    for (size_t i = 0; i < fit_.weights.size(); ++i) {
      WeightChange& weight = fit_.weights[i];
      const Eigen::Index index = IndexOf(i);
      if (std::abs(fit_.fit.x[index]) > kUnchanged) {
        weight.value.after =
            RoundWeight(weight.value.before * std::exp(fit_.fit.x[index]), weight.param.least,
                        weight.param.greatest, kinds_[i] == RecordedParam::Kind::kWhole);
        x_[index] = std::log(weight.value.after / weight.value.before);
      }
      weight.sd = std::sqrt(fit_.fit.covariance(index, index));
      const auto [low, high] = std::minmax(
          {weight.value.after * std::exp(-weight.sd), weight.value.after * std::exp(weight.sd)});
      weight.low = std::max(low, weight.param.least);
      weight.high = std::min(high, weight.param.greatest);
    }
  }

  void Judge() {
    const Eigen::VectorXd recorded = Eigen::VectorXd::Zero(x_.size());
    const std::vector<bool> can_hold = HoldAtBest(fit_.model);
    std::vector<Preference> preferences;
    for (size_t i = 0; i < fit_.preferences.size(); ++i) {
      PreferenceResult& result = fit_.preferences[i];
      const Comparison& comparison = fit_.model.comparisons[i];
      const double before = Advantage(fit_.model, comparison.difference, recorded);
      const double after = Advantage(fit_.model, comparison.difference, x_);
      result.probability = {Logistic(before), Logistic(after)};
      result.holds = {Holds(comparison, before), Holds(comparison, after)};
      result.can_hold = can_hold[i];
      preferences.push_back(result.preference);
    }
    for (const size_t i : FindContradictions(preferences)) {
      fit_.preferences[i].is_contradicted = true;
    }
  }

  void AddNotes() {
    for (size_t i = 0; i < left_out_.size(); ++i) {
      if (!left_out_[i]) continue;
      fit_.notes.push_back(
          fmt::format("{} does not count: {}.", result_.runs[i].run->name, *left_out_[i]));
    }
    for (const WeightChange& weight : fit_.weights) {
      if (!weight.param.changes_course || weight.value.after == weight.value.before) continue;
      fit_.notes.push_back(
          fmt::format("{} also affects when an episode ends; returns are computed as if the "
                      "episodes had stayed "
                      "the same.",
                      weight.param.name));
    }
  }

  const ExperimentResult& result_;
  const std::vector<TermRecord>& terms_;
  std::vector<RecordedParam::Kind> kinds_;            // of the weights
  std::vector<std::optional<std::string>> left_out_;  // why, of the experiment's runs
  std::map<BehaviorName, Eigen::VectorXd> sums_;
  Eigen::VectorXd x_;  // of the rounded values
  PreferenceFit fit_;
};

}  // namespace

bool PreferenceFit::is_consistent() const {
  return std::ranges::all_of(preferences, [](const PreferenceResult& each) {
    return each.can_hold && !each.is_contradicted;
  });
}

std::vector<std::vector<Preference>> PreferencesByExperiment(
    const std::vector<ExperimentResult>& experiments, const std::vector<Preference>& preferences,
    const std::filesystem::path& folder) {
  std::map<std::string, size_t> experiment_of;  // by the names of runs
  for (size_t i = 0; i < experiments.size(); ++i) {
    for (const RunResult& run : experiments[i].runs) experiment_of[run.run->name] = i;
  }
  std::vector<std::vector<Preference>> sorted(experiments.size());
  for (const Preference& preference : preferences) {
    const auto better = experiment_of.find(preference.better.run);
    const auto worse = experiment_of.find(preference.worse.run);
    const std::string place =
        fmt::format("{}:{}", (folder / kPreferencesFile).string(), preference.line);
    if (better == experiment_of.end() || worse == experiment_of.end()) {
      const BehaviorName& unknown =
          better == experiment_of.end() ? preference.better : preference.worse;
      throw UserError(fmt::format("{}: there is no run `{}` that can be read", place, unknown.run));
    }
    if (better->second != worse->second) {
      throw UserError(fmt::format(
          "{}: {} and {} are runs of two experiments, {} and {}; a preference is between "
          "runs of one",
          place, preference.better.run, preference.worse.run,
          experiments[better->second].experiment->name,
          experiments[worse->second].experiment->name));
    }
    sorted[better->second].push_back(preference);
  }
  return sorted;
}

PreferenceFit FitPreferences(const ExperimentResult& result, const TaskParams& params,
                             const std::vector<Preference>& preferences, double expected_factor) {
  return Fitter(result, params, expected_factor).Fit(preferences);
}

}  // namespace runtime
