#include "compiler/bounds/phase_warnings.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compiler/check/copy_checked.h"
#include "compiler/check/report.h"
#include "compiler/check/transitions.h"
#include "compiler/check/traversal.h"

namespace compiler {
namespace {

using Transitions = std::vector<Transition>;

// The phases that can be reached from those of `seen`, themselves included.
std::vector<bool> Reached(const Transitions& transitions, std::vector<bool> seen,
                          uint32_t Transition::*from, uint32_t Transition::*to) {
  for (bool grows = true; grows;) {
    grows = false;
    for (const Transition& each : transitions) {
      if (!seen[each.*from] || seen[each.*to]) continue;
      seen[each.*to] = grows = true;
    }
  }
  return seen;
}

std::vector<bool> Reachable(const CheckedTask& task, const Transitions& transitions) {
  std::vector<bool> first(task.phases.size());
  first.front() = true;
  return Reached(transitions, first, &Transition::from, &Transition::to);
}

void WarnOfUnreachable(const CheckedTask& task, const std::vector<bool>& is_reachable,
                       Diagnostics& diagnostics) {
  for (size_t i = 0; i < task.phases.size(); ++i) {
    const CheckedPhase& phase = task.phases[i];
    if (is_reachable[i]) continue;
    Report(diagnostics, code::kUnreachablePhase, phase.span,
           fmt::format("no way leads to the phase `{}`", phase.name),
           {.help = fmt::format("an episode begins in `{}`: lead from there to this one with `next "
                                "{}`, or remove it",
                                task.phases.front().name, phase.name)});
  }
}

// ---- Phases without end -------------------------------------------------------------------------

size_t CountEnds(const CheckedBlock& block) {
  size_t count = 0;
  ForEachStatement(block, [&](const CheckedStatement& statement) {
    if (std::holds_alternative<CheckedEnd>(statement.node)) ++count;
  });
  return count;
}

// Where the task ends its episodes only in phases: those from which no end can be reached, though
// they can, and the first of them on each way.
void WarnOfEndless(const CheckedTask& task, const Transitions& transitions,
                   const std::vector<bool>& is_reachable, Diagnostics& diagnostics) {
  size_t all = 0;
  for (const CheckedEvent& event : task.events) all += CountEnds(event.body);
  size_t in_phases = 0;
  std::vector<bool> ends;
  for (const CheckedBlock& block : FindPhaseSwitch(task)->blocks) {
    const size_t count = CountEnds(block);
    ends.push_back(count > 0);
    in_phases += count;
  }
  if (all == 0 || all > in_phases) return;
  const std::vector<bool> can_end =
      Reached(transitions, std::move(ends), &Transition::to, &Transition::from);
  std::vector<bool> is_entered(task.phases.size());
  is_entered.front() = true;
  for (const Transition& each : transitions)
    if (is_reachable[each.from] && can_end[each.from]) is_entered[each.to] = true;
  for (size_t i = 0; i < task.phases.size(); ++i) {
    const CheckedPhase& phase = task.phases[i];
    if (!is_reachable[i] || can_end[i] || !is_entered[i]) continue;
    Report(
        diagnostics, code::kEndlessPhase, phase.span,
        fmt::format("once `{}` begins, the episode never ends", phase.name),
        {.note = "there is no end in it, in what may come after it, or in an event",
         .help = fmt::format("leave it with `next`, or limit its time: `phase {} within 5 s else "
                             "OTHER`",
                             phase.name)});
  }
}

// ---- Circles that pay ---------------------------------------------------------------------------

// What a condition needs of the robot.
enum class Need {
  kNothing,  // it holds by itself, sooner or later
  kState,    // something that may last: a contact, a place
  kProgress  // something that changes
};

Need NeedOf(const CheckedTask& task, const CheckedExpression& condition) {
  Need need = Need::kNothing;
  ForEachPart(condition, [&](const CheckedExpression& part) {
    if (const auto* sensor = std::get_if<SensorRead>(&part.node))
      if (task.sensors[sensor->sensor].name != "time") need = std::max(need, Need::kState);
    const auto* memory = std::get_if<MemoryRead>(&part.node);
    const bool is_other = memory != nullptr && memory->memory != task.phase_memory.present &&
                          memory->memory != task.phase_memory.time;
    const bool is_computed = std::holds_alternative<LocalRead>(part.node) ||
                             std::holds_alternative<RewardSoFar>(part.node);
    if (is_other || is_computed) need = Need::kProgress;
  });
  return need;
}

using Condition = Transition::Condition;

bool AreSame(const Condition& a, const Condition& b) {
  return a.holds == b.holds && IsSame(*a.expression, *b.expression);
}

// The circles that are run through while one state lasts, or in any state.
class CircleSearch {
 public:
  CircleSearch(const CheckedTask& task, const TaskBounds& bounds, const Transitions& transitions)
      : task_(task), bounds_(bounds), transitions_(transitions) {}

  void Warn(Diagnostics& diagnostics) {
    Search(nullptr, diagnostics);
    for (const Transition& each : transitions_)
      for (const Condition& condition : each.conditions)
        if (NeedOf(task_, *condition.expression) == Need::kState) Search(&condition, diagnostics);
  }

 private:
  // `state`: the condition that holds all the time; null: none has to.
  void Search(const Condition* state, Diagnostics& diagnostics) {
    Transitions open;
    for (const Transition& each : transitions_)
      if (IsOpen(each, state)) open.push_back(each);
    for (const Transition& first : open) {
      if (Pays(first) <= 0 || said_.contains(first.span.begin)) continue;
      const auto circle = CircleFrom(first, open);
      if (!circle) continue;
      double sum = 0;
      for (const Transition* each : *circle) sum += Pays(*each);
      if (sum > 0) Say(*circle, state, diagnostics);
    }
  }

  bool IsOpen(const Transition& transition, const Condition* state) const {
    return std::ranges::all_of(transition.conditions, [&](const Condition& condition) {
      if (state != nullptr && AreSame(condition, *state)) return true;
      return NeedOf(task_, *condition.expression) == Need::kNothing;
    });
  }

  // At most, each time.
  double Pays(const Transition& transition) const {
    double sum = 0;
    for (const CheckedReward* reward : transition.payments)
      if (const auto& payment = bounds_.terms[reward->term].payment) sum += payment->high;
    return sum;
  }

  // The shortest way from the end of `first` back to its beginning, behind `first`.
  static std::optional<std::vector<const Transition*>> CircleFrom(const Transition& first,
                                                                  const Transitions& open) {
    std::vector<std::vector<const Transition*>> ways{{&first}};
    std::set<uint32_t> seen;
    for (size_t i = 0; i < ways.size(); ++i) {
      const uint32_t place = ways[i].back()->to;
      if (place == first.from) return ways[i];
      if (!seen.insert(place).second) continue;
      for (const Transition& next : open) {
        if (next.from != place) continue;
        ways.push_back(ways[i]);
        ways.back().push_back(&next);
      }
    }
    return std::nullopt;
  }

  // Where the circle asks for it first.
  static Span StateOf(const std::vector<const Transition*>& circle, const Condition& state) {
    for (const Transition* each : circle)
      for (const Condition& condition : each->conditions)
        if (AreSame(condition, state)) return condition.expression->span;
    return state.expression->span;
  }

  void Say(const std::vector<const Transition*>& circle, const Condition* state,
           Diagnostics& diagnostics) {
    std::vector<std::string> names;
    for (const Transition* each : circle) {
      said_.insert(each->span.begin);
      names.push_back(task_.phases[each->from].name);
    }
    const Transition& first = *circle.front();
    Explanation explanation{.help = "let a phase end only with what the robot has to do in it",
                            .labels = {{first.payments.front()->value.span, "paid each time"}}};
    if (state != nullptr)
      explanation.labels.push_back(
          {StateOf(circle, *state),
           state->holds ? "it is enough that this lasts" : "it is enough that this never holds"});
    Report(diagnostics, code::kPaidCircle, first.span,
           fmt::format("{} in a circle that pays each time, {}",
                       names.size() == 1 ? fmt::format("`{}` follows itself", names.front())
                                         : List(names) + " follow each other",
                       state != nullptr ? "though nothing changes" : "whatever the robot does"),
           std::move(explanation));
  }

  const CheckedTask& task_;
  const TaskBounds& bounds_;
  const Transitions& transitions_;
  std::set<uint32_t> said_;  // where those transitions begin that have been warned of
};

}  // namespace

void WarnOfPhases(const CheckedTask& task, const TaskBounds& bounds, Diagnostics& diagnostics) {
  if (task.phases.empty()) return;
  const Transitions transitions = TransitionsOf(task);
  const std::vector<bool> is_reachable = Reachable(task, transitions);
  WarnOfUnreachable(task, is_reachable, diagnostics);
  WarnOfEndless(task, transitions, is_reachable, diagnostics);
  CircleSearch(task, bounds, transitions).Warn(diagnostics);
}

}  // namespace compiler
