#include "compiler/bounds/warnings.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "compiler/bounds/bounds.h"
#include "compiler/bounds/bounds_text.h"
#include "compiler/bounds/domains.h"
#include "compiler/bounds/early_death.h"
#include "compiler/bounds/end_warnings.h"
#include "compiler/bounds/hidden_state.h"
#include "compiler/bounds/observation_warnings.h"
#include "compiler/bounds/phase_warnings.h"
#include "compiler/check/fold.h"
#include "compiler/check/report.h"
#include "compiler/check/traversal.h"

namespace compiler {
namespace {

// ---- What never happens -------------------------------------------------------------------------

class NeverHappens {
 public:
  NeverHappens(const TaskBounds& bounds, Diagnostics& diagnostics) : diagnostics_(diagnostics) {
    for (const ConditionBounds& condition : bounds.conditions)
      conditions_[{condition.span.begin, condition.span.end}] = &condition;
  }

  void Look(const CheckedEvent& event) {
    ForEachStatement(event.body, [&](const CheckedStatement& statement) {
      if (const auto* branches = std::get_if<CheckedIf>(&statement.node)) Look(*branches);
      if (const auto* require = std::get_if<CheckedRequire>(&statement.node))
        Look(require->condition, "what is required here never holds");
    });
  }

 private:
  void Look(const CheckedIf& branches) {
    for (size_t i = 0; i < branches.branches.size(); ++i) {
      const CheckedExpression& condition = branches.branches[i].condition;
      Look(condition, "this condition is never true");
      const bool has_rest = i + 1 < branches.branches.size() || !branches.otherwise.empty();
      const ConditionBounds* bounds = NewBoundsOf(condition);
      if (bounds != nullptr && !bounds->may_be_false && has_rest)
        Say(*bounds, "this condition is always true, so its `else` never runs");
    }
  }

  void Look(const CheckedExpression& condition, std::string message) {
    const ConditionBounds* bounds = NewBoundsOf(condition);
    if (bounds != nullptr && !bounds->may_be_true) Say(*bounds, std::move(message));
  }

  // Nothing for a constant, for what is never reached, and for what was said already.
  const ConditionBounds* NewBoundsOf(const CheckedExpression& condition) const {
    const std::pair place(condition.span.begin, condition.span.end);
    const auto found = conditions_.find(place);
    const bool is_new = found != conditions_.end() && !said_.contains(place);
    return is_new && !ValueOf(condition) ? found->second : nullptr;
  }

  void Say(const ConditionBounds& condition, std::string message) {
    said_.insert({condition.span.begin, condition.span.end});
    Explanation explanation;
    for (const ConditionBounds::Operand& operand : condition.operands)
      explanation.labels.push_back(
          {operand.span, fmt::format("{} here", RangeText(operand.value, operand.unit))});
    if (condition.operands.empty())
      explanation.note = "what was checked before, or what is remembered, excludes it";
    Report(diagnostics_, code::kNeverHappens, condition.span, std::move(message),
           std::move(explanation));
  }

  Diagnostics& diagnostics_;
  std::map<std::pair<uint32_t, uint32_t>, const ConditionBounds*> conditions_;
  std::set<std::pair<uint32_t, uint32_t>> said_;
};

// ---- The size of terms --------------------------------------------------------------------------

double SizeOf(const std::optional<Interval>& value) { return value ? Magnitude(*value) : 0; }

std::vector<double> SizesOf(const TaskBounds& bounds, bool are_rates) {
  std::vector<double> sizes;
  for (const TermBounds& term : bounds.terms)
    sizes.push_back(SizeOf(are_rates ? term.rate : term.payment));
  return sizes;
}

// A term is held against what another one is in moderate motions, not against its bound: that may
// be a hundred times what the robot ever does.
void WarnOfTinyTerms(const CheckedTask& task, const TaskBounds& bounds, const TaskBounds& moderate,
                     bool are_rates, Diagnostics& diagnostics) {
  constexpr double kShareThatMatters = 1e-3;
  const std::vector<double> sizes = SizesOf(bounds, are_rates);
  const std::vector<double> usual = SizesOf(moderate, are_rates);
  const auto largest = std::ranges::max_element(usual);
  if (largest == usual.end() || *largest == kInfinity) return;
  const auto first = static_cast<size_t>(largest - usual.begin());
  for (size_t i = 0; i < sizes.size(); ++i) {
    // What is also paid in another way may matter by that.
    const bool has_both = bounds.terms[i].rate && bounds.terms[i].payment;
    if (has_both || sizes[i] == 0 || sizes[i] > kShareThatMatters * *largest) continue;
    const bool is_share = *largest < sizes[first];
    Report(
        diagnostics, code::kTinyTerm, task.terms[i].span,
        fmt::format("`{}` hardly matters beside `{}`", task.terms[i].name, task.terms[first].name),
        {.note = fmt::format("it is at most {}{}, the other {}{}", EndText(sizes[i]),
                             are_rates ? " per second" : "", EndText(*largest),
                             is_share ? " in moderate motions" : "")});
  }
}

void WarnOfTermsThatPayNothing(const CheckedTask& task, const TaskBounds& bounds,
                               Diagnostics& diagnostics) {
  for (size_t i = 0; i < task.terms.size(); ++i) {
    const TermBounds& term = bounds.terms[i];
    const bool is_paid = term.rate || term.payment;
    if (is_paid && SizeOf(term.rate) == 0 && SizeOf(term.payment) == 0)
      Report(diagnostics, code::kNeverHappens, task.terms[i].span,
             fmt::format("`{}` never pays anything", task.terms[i].name),
             {.note = "it is always 0"});
  }
}

// What is the same everywhere guides nowhere.
void WarnOfConstantPotentials(const CheckedTask& task, const TaskBounds& bounds,
                              Diagnostics& diagnostics) {
  for (size_t i = 0; i < task.terms.size(); ++i) {
    const auto& potential = bounds.terms[i].potential;
    if (potential && potential->low == potential->high)
      Report(diagnostics, code::kConstantPotential, task.terms[i].span,
             fmt::format("the potential `{}` is the same everywhere", task.terms[i].name),
             {.note = "it guides the learner nowhere: only its changes are paid"});
  }
}

// A sensor without range is no harm; what grows or explodes by itself is.
bool IsHarm(const CheckedTask& task, const Cause& cause) {
  if (cause.kind == Cause::kOperation) return true;
  const auto memory = std::ranges::find(task.memory, cause.name, &CheckedMemory::name);
  return cause.kind == Cause::kMemory && memory->scope != MemoryScope::kPerAction;
}

void WarnOfTermsWithoutBound(const CheckedTask& task, const TaskBounds& bounds,
                             Diagnostics& diagnostics) {
  const auto is_unbounded = [](const TermBounds& term) { return !term.causes.empty(); };
  if (std::ranges::none_of(bounds.terms, is_unbounded)) return;
  constexpr double kAnySensor = 1e9;
  const TaskBounds with_ranges = ComputeBounds(task, {.without_range = kAnySensor});
  for (size_t i = 0; i < task.terms.size(); ++i) {
    const auto& causes = with_ranges.terms[i].causes;
    const auto harm =
        std::ranges::find_if(causes, [&](const Cause& cause) { return IsHarm(task, cause); });
    if (harm == causes.end()) continue;
    const bool is_memory = harm->kind == Cause::kMemory;
    Report(diagnostics, code::kUnboundedTerm, task.terms[i].span,
           fmt::format("`{}` has no bound", task.terms[i].name),
           {.help = "limit it, as in `clamp(x, low, high)` or `tanh(x)`",
            .labels = {{harm->span, is_memory ? "this can grow forever" : harm->name}}});
  }
}

}  // namespace

void WarnOfBounds(const CheckedTask& task, const Sources& sources, const TaskBounds& bounds,
                  Diagnostics& diagnostics) {
  NeverHappens never(bounds, diagnostics);
  for (const CheckedEvent& event : task.events) never.Look(event);
  WarnOfTermsThatPayNothing(task, bounds, diagnostics);
  WarnOfConstantPotentials(task, bounds, diagnostics);
  const TaskBounds moderate = ComputeBounds(task, {.share_of_nominal = kModerateShare});
  WarnOfTinyTerms(task, bounds, moderate, true, diagnostics);
  WarnOfTinyTerms(task, bounds, moderate, false, diagnostics);
  WarnOfTermsWithoutBound(task, bounds, diagnostics);
  WarnOfMemory(task, sources, bounds, diagnostics);
  WarnOfObservations(task, sources, bounds, diagnostics);
  WarnOfLeftDomains(bounds, diagnostics);
  WarnOfEnds(task, bounds, diagnostics);
  WarnOfEarlyDeath(task, diagnostics);
  WarnOfPhases(task, bounds, diagnostics);
}

}  // namespace compiler
