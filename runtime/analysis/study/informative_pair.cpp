#include "runtime/analysis/study/informative_pair.h"

#include "runtime/analysis/study/compared_behavior.h"

namespace runtime {
namespace {

// The group in which the behavior is: not that of an episode in the middle of a run.
std::optional<size_t> GroupOf(const ExperimentResult& result, const BehaviorName& behavior) {
  const std::optional<size_t> run = FindRun(result, behavior.run);
  return run && !behavior.episode ? result.runs[*run].group : std::nullopt;
}

std::set<GroupPair> ComparedPairs(const PreferenceFit& fit) {
  std::set<GroupPair> pairs;
  for (const PreferenceResult& each : fit.preferences) {
    const std::optional<size_t> better = GroupOf(*fit.result, each.preference.better);
    const std::optional<size_t> worse = GroupOf(*fit.result, each.preference.worse);
    if (better && worse) pairs.insert(std::minmax({*better, *worse}));
  }
  return pairs;
}

double InformationOf(const PreferenceFit& fit, const GroupPair& pair) {
  const auto sums = [&](size_t group) {
    const RunResult& run = fit.result->runs[fit.result->groups[group].typical];
    return TermSums(run, {run.run->name, std::nullopt});
  };
  return ExpectedInformation(fit.model, fit.fit, sums(pair.first) - sums(pair.second));
}

}  // namespace

std::optional<GroupPair> MostInformativePair(const PreferenceFit& fit,
                                             const std::set<GroupPair>& skipped) {
  const std::vector<BehaviorGroup>& groups = fit.result->groups;
  const std::set<GroupPair> compared = ComparedPairs(fit);
  std::optional<GroupPair> best;
  double most = -1;
  for (size_t a = 0; a < groups.size(); ++a) {
    for (size_t b = a + 1; b < groups.size(); ++b) {
      const GroupPair pair(a, b);
      if (compared.contains(pair) || skipped.contains(pair)) continue;
      if (fit.rescored.runs[groups[a].typical].left_out) continue;
      if (fit.rescored.runs[groups[b].typical].left_out) continue;
      const double information = InformationOf(fit, pair);
      if (information <= most) continue;
      most = information;
      best = pair;
    }
  }
  return best;
}

}  // namespace runtime
