#include "runtime/core/task/task_phases.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace runtime {

TaskPhases::TaskPhases(host::TaskFrame& host)
    : host_(host),
      phases_(host.plugin().phases, host.plugin().phase_count),
      sums_(phases_.size()) {}

void TaskPhases::StartEpisode() {
  std::ranges::fill(sums_, PhaseSums());
  if (!phases_.empty()) Begin(0);
}

// What no phase stands for would be a damaged plugin's.
size_t TaskPhases::present() const {
  if (phases_.empty()) return 0;
  const taskc_int64 present = host_.PresentPhase();
  return present >= 0 && static_cast<size_t>(present) < phases_.size()
             ? static_cast<size_t>(present)
             : 0;
}

void TaskPhases::TakeOver(const TaskPhases& old) {
  if (phases_.empty()) return;
  const auto find = [&](const taskc_phase& phase) {
    const auto same = std::ranges::find_if(phases_, [&](const taskc_phase& candidate) {
      return std::string_view(candidate.name) == phase.name;
    });
    return static_cast<size_t>(same - phases_.begin());
  };
  for (size_t i = 0; i < old.phases_.size(); ++i) {
    const size_t same = find(old.phases_[i]);
    if (same < phases_.size()) sums_[same] = old.sums_[i];
  }
  const size_t same = old.phases_.empty() ? phases_.size() : find(old.phases_[old.present()]);
  if (same == phases_.size()) return Begin(0);
  host_.SetPhase(static_cast<taskc_int64>(same));
}

void TaskPhases::Begin(size_t phase) {
  host_.SetPhase(static_cast<taskc_int64>(phase));
  host_.SetPhaseTime(0);
}

}  // namespace runtime
