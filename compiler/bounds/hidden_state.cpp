#include "compiler/bounds/hidden_state.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/bounds/dependence.h"
#include "compiler/check/report.h"
#include "compiler/check/time_functions.h"
#include "compiler/check/traversal.h"

namespace compiler {
namespace {

// Something that is remembered, and how messages call it.
struct Remembered {
  uint32_t memory = 0;
  std::string name;  // "`fallen`", "the goal `velocity`"
  std::string help;  // how the learner gets to see it
};

class HiddenState {
 public:
  HiddenState(const CheckedTask& task, const Sources& sources, const TaskBounds& bounds,
              Diagnostics& diagnostics)
      : task_(task),
        sources_(sources),
        bounds_(bounds),
        dependence_(DependenceOf(task)),
        diagnostics_(diagnostics) {
    for (const CheckedObservation& observation : task.observations)
      ForEachPart(observation.value, [&](const CheckedExpression& part) {
        if (const auto* read = std::get_if<MemoryRead>(&part.node)) shown_.insert(read->memory);
      });
  }

  void Warn() {
    for (uint32_t i = 0; i < task_.memory.size(); ++i)
      if (task_.memory[i].is_declared)
        Look({i, fmt::format("`{}`", task_.memory[i].name),
              fmt::format("`observe {}`", task_.memory[i].name)});
    if (task_.observations.empty()) return;
    for (const CheckedGoal& goal : task_.goals)
      Look({goal.memory, fmt::format("the goal `{}`", goal.name),
            fmt::format("`observe {}`", goal.name)});
    if (!task_.phases.empty()) {
      Look({task_.phase_memory.present, "the phase", "`observe phase`"});
      Look({task_.phase_memory.time, "`phase_time`", "`observe phase_time`"});
    }
    for (const CheckedTimeFunction& function : task_.time_functions) {
      const std::string_view name = NameOf(function.function);
      Look({function.value, fmt::format("what `{}` gives here", name),
            fmt::format("`observe NAME = {}(...)`, with the same arguments", name)});
    }
  }

 private:
  void Look(const Remembered& remembered) {
    const uint32_t memory = remembered.memory;
    const bool is_short = task_.memory[memory].scope == MemoryScope::kPerAction;
    if (is_short || dependence_.sensed.contains(memory)) return;
    const Dependent* reward = FirstDependent(dependence_.rewards, memory);
    const Dependent* end = FirstDependent(dependence_.ends, memory);
    const Dependent* first = reward != nullptr ? reward : end;
    if (first == nullptr) return;
    if (NeverReset(memory)) {
      ReportNeverReset(memory, first->span);
    } else if (!task_.observations.empty()) {
      if (!shown_.contains(memory)) ReportNotShown(remembered, reward != nullptr, first->span);
    } else if (reward != nullptr) {
      ReportHidden(remembered, reward->span);
    }
  }

  // What depends on `memory`, directly or not.
  const Dependent* FirstDependent(const std::vector<Dependent>& all, uint32_t memory) const {
    const auto depends = [&](const Dependent& dependent) {
      return WithSources(dependence_, dependent.memory).contains(memory);
    };
    const auto found = std::ranges::find_if(all, depends);
    return found == all.end() ? nullptr : &*found;
  }

  bool NeverReset(uint32_t memory) const {
    const CheckedMemory& declared = task_.memory[memory];
    return declared.is_declared && declared.scope == MemoryScope::kPerRun &&
           dependence_.accumulated.contains(memory) && !IsBounded(Hull(bounds_.memory[memory]));
  }

  void ReportNeverReset(uint32_t memory, Span dependent) {
    const CheckedMemory& declared = task_.memory[memory];
    Report(diagnostics_, code::kNeverReset, declared.span,
           fmt::format("`{}` grows through the whole run: nothing ever resets it", declared.name),
           {.help = "leave out `per run`, or reset it in `on start_of_episode`",
            .labels = {{dependent, "this depends on it"}}});
  }

  bool IsInherited(Span span) const { return sources_.IndexOf(span) != 0; }

  // Of inherited memory it is said where the task, other than its base, begins to observe.
  Span PlaceOf(const CheckedMemory& memory) const {
    const Span first = task_.observations.front().span;
    return IsInherited(memory.span) && !IsInherited(first) ? first : memory.span;
  }

  void ReportNotShown(const Remembered& remembered, bool is_reward, Span dependent) {
    Report(diagnostics_, code::kHiddenMemory, PlaceOf(task_.memory[remembered.memory]),
           fmt::format("{} depend on {}, which no observation shows",
                       is_reward ? "rewards" : "ends", remembered.name),
           {.note = fmt::format("to the agent, the same state {} at different times",
                                is_reward ? "is paid differently" : "ends, or does not,"),
            .help = fmt::format("show it: {}", remembered.help),
            .labels = {{dependent, "this depends on it"}}});
  }

  void ReportHidden(const Remembered& remembered, Span dependent) {
    Report(diagnostics_, code::kHiddenMemory, task_.memory[remembered.memory].span,
           fmt::format("rewards depend on {}, which the agent does not see", remembered.name),
           {.note = "to the agent, the same state is paid differently at different times",
            .labels = {{dependent, "this depends on it"}}});
  }

  const CheckedTask& task_;
  const Sources& sources_;
  const TaskBounds& bounds_;
  const Dependence dependence_;
  Diagnostics& diagnostics_;
  std::set<uint32_t> shown_;  // memory that an observation reads
};

}  // namespace

void WarnOfMemory(const CheckedTask& task, const Sources& sources, const TaskBounds& bounds,
                  Diagnostics& diagnostics) {
  HiddenState(task, sources, bounds, diagnostics).Warn();
}

}  // namespace compiler
