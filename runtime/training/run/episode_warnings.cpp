#include "runtime/training/run/episode_warnings.h"

#include <fmt/format.h>
#include <taskc/largest_reward.h>

#include "runtime/core/module/end_kind_name.h"
#include "runtime/training/run/fault_explanation.h"

namespace runtime {
namespace {

// "tasks/crawling.task:12"
std::string PlaceText(const taskc_plugin& plugin, const taskc_place& place) {
  return fmt::format("{}:{}", plugin.sources[place.source].file, place.line);
}

}  // namespace

void EpisodeWarnings::About(const EpisodeRecord& episode, const UniversalTask& task,
                            const Learner& learner) {
  if (episode.active.end_kind == EndKindName(EndKind::kDiverged)) {
    warn_(
        fmt::format("warning: episode {}: {}, after {:.3f} s; its last action was not learned from",
                    episode.number, episode.active.end_reason, episode.simulated_seconds));
  }
  if (task.fault_count() > 0) AboutFaults(episode, task);
  if (learner.passed_over_count() > 0) AboutLearner(episode, learner);
  if (episode.active.violations > 0) AboutViolations(episode, task);
  AboutObservations(episode, task);
}

void EpisodeWarnings::AboutFaults(const EpisodeRecord& episode, const UniversalTask& task) {
  std::string terms;
  for (size_t i = 0; i < task.faults().size(); ++i) {
    const Incidents& faults = task.faults()[i];
    const taskc_reward_term& term = task.plugin().terms[i];
    if (faults.count == 0) continue;
    terms += fmt::format("{}`{}` ({}) {}x, first at {:.3f} s", terms.empty() ? "" : "; ", term.name,
                         PlaceText(task.plugin(), term.place), faults.count, faults.first_time);
  }
  if (terms.empty()) terms = fmt::format("what `{}` pays in one event", task.plugin().name);
  warn_(fmt::format("warning: episode {}: not finite, or beyond {:g}, and so not paid: {}{}",
                    episode.number, TASKC_LARGEST_REWARD, terms, Explanation(task)));
}

bool EpisodeWarnings::HasNewFault(const UniversalTask& task) const {
  const FaultState& fault = task.instance().fault_state();
  return fault.is_kept() && !explained_.contains({task.instance().id(), fault.term()});
}

std::string EpisodeWarnings::Explanation(const UniversalTask& task) {
  if (!HasNewFault(task)) return "";
  const FaultState& fault = task.instance().fault_state();
  explained_.insert({task.instance().id(), fault.term()});
  const std::string text = ExplainFault(run_, task.instance().id(), task.plugin(), fault);
  return text.empty() ? "" : fmt::format(": {}", text);
}

void EpisodeWarnings::AboutObservations(const EpisodeRecord& episode, const UniversalTask& task) {
  std::string seen;
  for (size_t i = 0; i < task.observation_faults().size(); ++i) {
    const Incidents& faults = task.observation_faults()[i];
    if (faults.count == 0) continue;
    seen += fmt::format("{}`{}` {}x, first at {:.3f} s", seen.empty() ? "" : "; ",
                        task.plugin().observations[i].name, faults.count, faults.first_time);
  }
  if (seen.empty()) return;
  warn_(fmt::format("warning: episode {}: not finite, and 0 to the learner: {}", episode.number,
                    seen));
}

void EpisodeWarnings::AboutLearner(const EpisodeRecord& episode, const Learner& learner) {
  warn_(fmt::format(
      "warning: episode {}: {} of {} actions were not learned from, since that gave no finite "
      "values: the learner diverges; lower `{}.learning_rate`, or the rewards",
      episode.number, learner.passed_over_count(), episode.actions, learner.name()));
}

void EpisodeWarnings::AboutViolations(const EpisodeRecord& episode, const UniversalTask& task) {
  std::vector<bool>& noted = violations_noted_[episode.active.task];
  noted.resize(task.violations().size());
  for (size_t i = 0; i < noted.size(); ++i) {
    const Incidents& violations = task.violations()[i];
    if (violations.count == 0 || noted[i]) continue;
    noted[i] = true;
    const taskc_requirement& requirement = task.plugin().requirements[i];
    warn_(fmt::format(
        "warning: episode {}: {} requires `{}` ({}), which did not hold at {:.3f} s; such episodes "
        "are truncated and counted, and this is said once",
        episode.number, task.plugin().name, requirement.reason,
        PlaceText(task.plugin(), requirement.place), violations.first_time));
  }
}

}  // namespace runtime
