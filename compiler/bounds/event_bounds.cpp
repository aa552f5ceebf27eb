#include "compiler/bounds/event_bounds.h"

#include <algorithm>
#include <utility>

#include "compiler/bounds/causes.h"
#include "compiler/bounds/domains.h"
#include "compiler/bounds/expression_bounds.h"
#include "compiler/bounds/narrowing.h"
#include "compiler/check/assignment.h"
#include "compiler/check/traversal.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

// Does it give the same value wherever in the callback it is computed?
bool IsLasting(const CheckedExpression& expression,
               const std::vector<const CheckedExpression*>& definitions) {
  bool is_lasting = true;
  ForEachPart(expression, [&](const CheckedExpression& part) {
    const auto* local = std::get_if<LocalRead>(&part.node);
    const bool changes = std::holds_alternative<MemoryRead>(part.node) ||
                         std::holds_alternative<RewardSoFar>(part.node) ||
                         (local != nullptr && definitions[local->local] == nullptr);
    if (changes) is_lasting = false;
  });
  return is_lasting;
}

void JoinInto(std::optional<Interval>& all, const Interval& more) {
  all = all ? Join(*all, more) : more;
}

}  // namespace

Values EventBounds::Run(const CheckedEvent& event, Values before) {
  before.locals.assign(event.locals.size(), Box());
  definitions_.assign(event.locals.size(), nullptr);
  local_causes_.assign(event.locals.size(), {});
  Reached values = before;
  Run(event.body, values);
  return values ? std::move(*values) : before;
}

void EventBounds::Run(const CheckedBlock& block, Reached& values) {
  for (const CheckedStatement& statement : block) {
    if (!values) return;
    std::visit([&](const auto& node) { Run(node, values); }, statement.node);
  }
}

void EventBounds::Run(const CheckedLet& let, Reached& values) {
  FindDomainsLeft(let.value, *values);
  values->locals[let.local] = ExpressionBounds(task_, *values).AllOf(let.value);
  definitions_[let.local] = IsLasting(let.value, definitions_) ? &let.value : nullptr;
  if (found_ != nullptr)
    local_causes_[let.local] = CausesOf(task_, *values, local_causes_, let.value);
}

void EventBounds::Run(const CheckedAssign& assign, Reached& values) {
  FindDomainsLeft(assign.value, *values);
  const Box value = ExpressionBounds(task_, *values).AllOf(assign.value);
  const Type& type = task_.memory[assign.memory].type;
  Box& memory = values->memory[assign.memory];
  const auto assigned = [&](const Interval& before, const Interval& with) {
    if (assign.op == AssignOperator::kSet) return with;
    return Calculate(OperatorOf(assign.op), before, with, type.scalar);
  };
  const bool sets_all = assign.elements.empty();
  if (type.size() > kTrackedElements) {
    // One interval for all elements: those that are not set keep their values.
    const Interval set = assigned(memory[0], Hull(value));
    memory.Set(0, sets_all ? set : Join(memory[0], set));
    return;
  }
  std::vector<Interval> elements(type.size());
  for (uint32_t i = 0; i < type.size(); ++i) elements[i] = memory[i];
  const size_t count = sets_all ? elements.size() : assign.elements.size();
  for (size_t i = 0; i < count; ++i) {
    Interval& element = elements[sets_all ? i : assign.elements[i]];
    element = assigned(element, value[i]);
  }
  memory = Box(std::move(elements));
}

void EventBounds::Run(const CheckedIf& branches, Reached& values) {
  Reached after;
  const auto leave_by = [&](Reached& end) {
    if (end) after = after ? Join(*after, *end) : std::move(*end);
  };
  for (const CheckedIfBranch& branch : branches.branches) {
    if (!values) break;
    FindDomainsLeft(branch.condition, *values);
    Reached inside = values;
    if (!Assume(branch.condition, true, *inside)) inside.reset();
    Reached outside = values;
    if (!Assume(branch.condition, false, *outside)) outside.reset();
    Note(branch.condition, inside.has_value(), outside.has_value(), *values);
    Run(branch.body, inside);
    leave_by(inside);
    values = std::move(outside);
  }
  Run(branches.otherwise, values);
  leave_by(values);
  values = std::move(after);
}

void EventBounds::Run(const CheckedFor& loop, Reached& values) {
  for (const CheckedPass& pass : loop.passes) Run(pass.body, values);
}

void EventBounds::Run(const CheckedReward& reward, Reached& values) {
  const Interval value = ExpressionBounds(task_, *values).Of(reward.value);
  const Interval paid =
      reward.is_rate ? Calculate(BinaryOperator::kMultiply, value, values->time_step, Scalar::kReal)
                     : value;
  // What is not finite is not paid.
  Interval sum = Calculate(BinaryOperator::kAdd, values->reward, paid, Scalar::kReal);
  if (sum.may_be_nan || sum.may_be_infinite) sum = Join(sum, values->reward);
  values->reward = {sum.low, sum.high};
  if (found_ == nullptr) return;
  FindDomainsLeft(reward.value, *values);
  TermBounds& term = found_->terms[reward.term];
  JoinInto(reward.is_rate ? term.rate : term.payment, value);
  AddCauses(term.causes, CausesOf(task_, *values, local_causes_, reward.value));
}

void EventBounds::Run(const CheckedEnd& end, Reached&) {
  if (found_ != nullptr) found_->ends_reached[end.end] = true;
}

void EventBounds::Run(const CheckedLog& log, Reached& values) {
  if (found_ == nullptr) return;
  FindDomainsLeft(log.value, *values);
  ValueBounds& bounds = found_->logs[log.log];
  bounds.value = Join(bounds.value, ExpressionBounds(task_, *values).Of(log.value));
  AddCauses(bounds.causes, CausesOf(task_, *values, local_causes_, log.value));
}

void EventBounds::Run(const CheckedRedraw& redraw, Reached& values) {
  const CheckedGoal& goal = task_.goals[redraw.goal];
  values->memory[goal.memory] = GoalBounds(task_, *values, goal);
  if (goal.interval)
    values->memory[goal.interval->left] =
        ExpressionBounds(task_, *values).AllOf(goal.interval->length);
  values->memory[goal.draws] = Box(Interval{0, kInfinity});
}

// What it changes is looked at where the phases end.
void EventBounds::Run(const CheckedNext&, Reached&) {}

// Any phase may be the present one, and any the next.
void EventBounds::Run(const CheckedPhaseSwitch& phases, Reached& values) {
  const auto [present, time] = task_.phase_memory;
  Reached after;
  for (size_t i = 0; i < phases.blocks.size(); ++i) {
    Reached inside = values;
    inside->memory[present] = Box(Exactly(static_cast<double>(i)));
    Run(phases.blocks[i], inside);
    if (!inside) continue;
    if (const auto& limit = task_.phases[i].limit) {
      const Interval longest = ExpressionBounds(task_, *inside).Of(limit->time);
      inside->memory[time] = Box(Meet(inside->memory[time][0], {0, longest.high}));
    }
    after = after ? Join(*after, *inside) : std::move(*inside);
  }
  values = std::move(after);
  if (!values) return;
  values->memory[present] = Box(Interval{0, static_cast<double>(phases.blocks.size() - 1)});
  values->memory[time] = Join(values->memory[time], Box(Exactly(0)));
}

void EventBounds::Run(const CheckedAdvance& advance, Reached& values) {
  const CheckedTimeFunction& function = task_.time_functions[advance.function];
  const Box now = ExpressionBounds(task_, *values).AllOf(advance.value);
  const auto widen = [&](uint32_t memory, const Box& by) {
    values->memory[memory] = Join(values->memory[memory], by);
  };
  const Scalar scalar = advance.value.type.scalar;
  widen(function.value,
        TimeFunctionBounds(function.function, now, scalar, task_.longest_time_step));
  if (function.function == TimeFunction::kSince) return;
  const bool is_time = function.function == TimeFunction::kHeld;
  const Interval past = is_time ? Interval{0, kInfinity} : Hull(now);
  widen(function.past,
        MakeBox(std::vector<Interval>(task_.memory[function.past].type.size(), past)));
  if (function.function == TimeFunction::kDelay)
    widen(function.next, Box(Interval{0, static_cast<double>(function.steps - 1)}));
}

void EventBounds::Run(const CheckedPotentialStep& step, Reached& values) {
  const CheckedPotential& potential = task_.potentials[step.potential];
  const Interval value = ExpressionBounds(task_, *values).Of(step.value);
  Box& last = values->memory[potential.last];
  last = Join(last, Box(value));
  values->memory[potential.known] = Box(kAnyBool);
  values->memory[potential.paid] = Box(kAnyBool);
  if (found_ != nullptr) NotePotential(step, value, *values);
  if (step.moment == CheckedPotentialStep::kStart) return;
  // What is not finite, or of which the beginning is not known, is not paid.
  const Interval sum = Join(values->reward, Calculate(BinaryOperator::kAdd, values->reward,
                                                      PaymentOfPotential(last[0]), Scalar::kReal));
  values->reward = {sum.low, sum.high};
}

void EventBounds::NotePotential(const CheckedPotentialStep& step, const Interval& value,
                                const Values& values) const {
  if (step.moment == CheckedPotentialStep::kAction) FindDomainsLeft(step.value, values);
  TermBounds& term = found_->terms[task_.potentials[step.potential].term];
  JoinInto(term.potential, value);
  AddCauses(term.causes, CausesOf(task_, values, local_causes_, step.value));
}

// A callback goes on where what it requires does not hold.
void EventBounds::Run(const CheckedRequire& require, Reached& values) {
  FindDomainsLeft(require.condition, *values);
  const Interval truth = ExpressionBounds(task_, *values).Of(require.condition);
  Note(require.condition, MayBeTrue(truth), MayBeFalse(truth), *values);
}

bool EventBounds::Assume(const CheckedExpression& condition, bool truth, Values& values) const {
  // Twice: what the last part of an `and` says may narrow what the first part compares with.
  Narrowing narrowing(task_, definitions_, values);
  return narrowing.Assume(condition, truth) && narrowing.Assume(condition, truth);
}

void EventBounds::FindDomainsLeft(const CheckedExpression& expression, const Values& values) const {
  if (found_ != nullptr)
    FindLeftDomains(task_, values, definitions_, expression, found_->left_domains);
}

void EventBounds::Note(const CheckedExpression& condition, bool may_be_true, bool may_be_false,
                       const Values& values) {
  if (found_ == nullptr) return;
  const auto [place, is_new] = conditions_.try_emplace({condition.span.begin, condition.span.end},
                                                       found_->conditions.size());
  if (is_new) found_->conditions.push_back({.span = condition.span});
  ConditionBounds& bounds = found_->conditions[place->second];
  bounds.may_be_true = bounds.may_be_true || may_be_true;
  bounds.may_be_false = bounds.may_be_false || may_be_false;
  if (is_new) NoteOperands(condition, values, bounds);
}

void EventBounds::NoteOperands(const CheckedExpression& condition, const Values& values,
                               ConditionBounds& bounds) const {
  ForEachPart(condition, [&](const CheckedExpression& part) {
    const auto* binary = std::get_if<CheckedBinary>(&part.node);
    if (binary == nullptr || IsBool(binary->left->type) || !IsBool(part.type)) return;
    for (const CheckedExpression* operand : {binary->left.get(), binary->right.get()})
      if (!std::holds_alternative<Constant>(operand->node))
        bounds.operands.push_back(
            {operand->span, Hull(ExpressionBounds(task_, values).AllOf(*operand)), operand->unit});
  });
}

}  // namespace compiler
