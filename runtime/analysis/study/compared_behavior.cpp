#include "runtime/analysis/study/compared_behavior.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "runtime/base/suggestion.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

Eigen::VectorXd SumsAtTheEnd(const RunResult& run) {
  if (!run.run->is_finished()) {
    throw UserError(
        fmt::format("{} is not finished, so its behavior will change; compare one of its "
                    "episodes, `{}:{}`",
                    run.run->name, run.run->name, run.run->episodes.size()));
  }
  const std::vector<TermRecord>& terms = run.run->record.tasks.front().terms;
  Eigen::VectorXd sums(static_cast<Eigen::Index>(terms.size()));
  for (size_t i = 0; i < terms.size(); ++i) {
    const auto found = run.final.terms.find(terms[i].name);
    if (found == run.final.terms.end()) {
      throw UserError(
          fmt::format("{} has no sum of `{}` in its last episodes", run.run->name, terms[i].name));
    }
    sums[static_cast<Eigen::Index>(i)] = found->second;
  }
  return sums;
}

Eigen::VectorXd SumsOfEpisode(const StudyRun& run, int64_t number) {
  const auto found = std::ranges::find(run.episodes, number, &EpisodeRecord::number);
  if (found == run.episodes.end()) {
    throw UserError(
        fmt::format("{} has no episode {}; it has {}", run.name, number, run.episodes.size()));
  }
  const std::vector<double>& sums = found->active.terms;
  if (!std::ranges::all_of(sums, [](double sum) { return std::isfinite(sum); })) {
    throw UserError(
        fmt::format("episode {} of {} diverged and cannot be compared", number, run.name));
  }
  return Eigen::Map<const Eigen::VectorXd>(sums.data(), static_cast<Eigen::Index>(sums.size()));
}

// "crawling-fast-tree/seed3" is also called "seed3".
bool IsCalled(const std::string& run, const std::string& name) {
  return run == name || run.ends_with("/" + name);
}

struct Candidate {
  const ExperimentResult* experiment;
  std::string run;
};

class BehaviorFinder {
 public:
  BehaviorFinder(const std::vector<ExperimentResult>& experiments, const std::string& experiment) {
    for (const ExperimentResult& each : experiments) {
      if (experiment.empty() || each.experiment->name == experiment) experiments_.push_back(&each);
    }
  }

  std::vector<BehaviorName> Find(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      const std::vector<Candidate> candidates = CandidatesFor(name);
      if (candidates.size() == 1) clear_.insert(candidates.front().experiment);
    }
    std::vector<BehaviorName> behaviors;
    for (const std::string& name : names) behaviors.push_back(FindOne(name));
    return behaviors;
  }

 private:
  std::vector<Candidate> CandidatesFor(const std::string& name) const {
    const std::string run_name = ParseBehaviorName(name).run;
    std::vector<Candidate> candidates;
    for (const ExperimentResult* experiment : experiments_) {
      for (const RunResult& run : experiment->runs) {
        if (IsCalled(run.run->name, run_name)) candidates.push_back({experiment, run.run->name});
      }
    }
    return candidates;
  }

  BehaviorName FindOne(const std::string& name) const {
    std::vector<Candidate> candidates = CandidatesFor(name);
    if (candidates.size() > 1 && clear_.size() == 1) {
      std::erase_if(candidates,
                    [&](const auto& each) { return !clear_.contains(each.experiment); });
    }
    if (candidates.size() == 1) return {candidates.front().run, ParseBehaviorName(name).episode};
    if (candidates.empty()) throw UserError(UnknownText(name));
    std::vector<std::string> runs;
    for (const Candidate& candidate : candidates) runs.push_back("`" + candidate.run + "`");
    throw UserError(
        fmt::format("`{}` is one of several runs: {}; write one of these names, or say "
                    "which experiment: --experiment",
                    name, fmt::join(runs, ", ")));
  }

  std::string UnknownText(const std::string& name) const {
    std::vector<std::string> runs;
    for (const ExperimentResult* experiment : experiments_) {
      for (const RunResult& run : experiment->runs) runs.push_back(run.run->name);
    }
    return fmt::format("there is no run `{}`{}{}", ParseBehaviorName(name).run,
                       experiments_.size() == 1
                           ? fmt::format(" in {}", experiments_.front()->experiment->name)
                           : "",
                       Suggestion(name, runs));
  }

  std::vector<const ExperimentResult*> experiments_;
  std::set<const ExperimentResult*> clear_;  // to which a name leads without doubt
};

}  // namespace

std::optional<std::string> WhyIncomparable(const StudyRun& run) {
  if (run.changes == 0) return std::nullopt;
  const std::string& module = run.record.tasks.front().module;
  for (const ChangeRecord& change : RunDatabase::OpenToRead(run.folder).ReadChanges()) {
    if (!ChangesReward(change.change, module)) continue;
    return fmt::format("its task was changed while it learned ({})", change.text);
  }
  return std::nullopt;
}

Eigen::VectorXd TermSums(const RunResult& run, const BehaviorName& behavior) {
  return behavior.episode ? SumsOfEpisode(*run.run, *behavior.episode) : SumsAtTheEnd(run);
}

std::optional<size_t> FindRun(const ExperimentResult& result, const std::string& name) {
  for (size_t i = 0; i < result.runs.size(); ++i) {
    if (result.runs[i].run->name == name) return i;
  }
  return std::nullopt;
}

std::vector<BehaviorName> FindBehaviors(const std::vector<ExperimentResult>& experiments,
                                        const std::vector<std::string>& names,
                                        const std::string& experiment) {
  return BehaviorFinder(experiments, experiment).Find(names);
}

}  // namespace runtime
