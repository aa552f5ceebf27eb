#include "compiler/bounds/early_death.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "compiler/bounds/bounds.h"
#include "compiler/bounds/bounds_text.h"
#include "compiler/bounds/failures.h"
#include "compiler/check/report.h"
#include "compiler/check/traversal.h"

namespace compiler {
namespace {

// ---- What going on costs ------------------------------------------------------------------------

// Per second.
struct Cost {
  double least = 0;
  double most = 0;           // in moderate motions
  bool is_moderate = false;  // else it could be more
};

// Is this paid in every step?
bool IsPaidAlways(const CheckedTask& task, uint32_t term) {
  const auto pays = [term](const CheckedStatement& statement) {
    const auto* reward = std::get_if<CheckedReward>(&statement.node);
    return reward != nullptr && reward->is_rate && reward->term == term;
  };
  return std::ranges::any_of(task.events, [&](const CheckedEvent& event) {
    return std::ranges::any_of(event.body, pays);
  });
}

// Bounds of library functions have a few digits to spare: `-acos(x)` might pay 1e-323.
constexpr double kSpare = 1e-12;

bool CanCost(const std::optional<Interval>& value) { return value && value->low < -kSpare; }
bool CanPay(const std::optional<Interval>& value) { return value && value->high > kSpare; }

// Nothing where no cost is due in every step. The least is one where no rate can pay anything.
std::optional<Cost> CostOfGoingOn(const CheckedTask& task, const TaskBounds& bounds,
                                  const TaskBounds& moderate) {
  Cost cost;
  bool is_due = false;
  for (uint32_t i = 0; i < task.terms.size(); ++i) {
    const auto& rate = bounds.terms[i].rate;
    const auto& usual = moderate.terms[i].rate;
    if (!CanCost(rate)) continue;
    if (CanCost(usual)) cost.most -= usual->low;
    if (!usual || usual->low > rate->low) cost.is_moderate = true;
    if (!IsPaidAlways(task, i)) continue;
    cost.least -= rate->high;
    is_due = true;
  }
  if (cost.least < kSpare) cost.least = 0;
  return is_due ? std::optional(cost) : std::nullopt;
}

// The smallest C of `if time > C { truncate_episode ... }`; infinite where there is none.
double TimeLimit(const CheckedTask& task) {
  double limit = kInfinity;
  const auto look = [&](const CheckedIfBranch& branch) {
    const auto* comparison = std::get_if<CheckedBinary>(&branch.condition.node);
    if (comparison == nullptr || (comparison->op != BinaryOperator::kGreater &&
                                  comparison->op != BinaryOperator::kGreaterEqual))
      return;
    const auto* sensor = std::get_if<SensorRead>(&comparison->left->node);
    const auto* end = std::get_if<Constant>(&comparison->right->node);
    const bool is_time = sensor != nullptr && task.sensors[sensor->sensor].name == "time";
    const bool ends = std::ranges::any_of(branch.body, [](const CheckedStatement& statement) {
      return std::holds_alternative<CheckedEnd>(statement.node);
    });
    if (is_time && end != nullptr && ends) limit = std::min(limit, end->value);
  };
  for (const CheckedEvent& event : task.events)
    ForEachStatement(event.body, [&](const CheckedStatement& statement) {
      if (const auto* branches = std::get_if<CheckedIf>(&statement.node))
        std::ranges::for_each(branches->branches, look);
    });
  return limit;
}

// How long an agent that does not fail has to go on at least, as far as that can be seen [s].
double LeastTime(const CheckedTask& task) {
  const bool can_succeed = std::ranges::any_of(
      task.ends, [](const CheckedEndReason& end) { return end.kind == EndKind::kSuccess; });
  const double limit = TimeLimit(task);
  return can_succeed || limit == kInfinity ? std::min(limit, 1.0) : limit;
}

// ---- What failing costs -------------------------------------------------------------------------

// Can going on ever pay more than nothing?
bool CanGain(const TaskBounds& bounds, const Failure& failure) {
  for (uint32_t i = 0; i < bounds.terms.size(); ++i) {
    if (CanPay(bounds.terms[i].rate)) return true;
    if (CanPay(bounds.terms[i].payment) && !failure.only_here.contains(i)) return true;
  }
  return false;
}

// What is paid for a failure. A related payment may be one for it; but only as far as it is a cost:
// else it is paid for what is to be achieved.
Interval PaidFor(const Failure& failure, const TaskBounds& bounds) {
  Interval paid = Exactly(0);
  const auto add = [&](uint32_t term, double most) {
    const auto& payment = bounds.terms[term].payment;
    if (!payment) return;
    paid.low += std::min(payment->low, most);
    paid.high += std::min(payment->high, most);
  };
  for (const uint32_t term : failure.beside) add(term, kInfinity);
  for (const uint32_t term : failure.related) add(term, 0);
  return paid;
}

// ---- Words --------------------------------------------------------------------------------------

// `seconds`: how long it has to be paid at least.
std::string TextOf(const Cost& cost, double seconds) {
  const std::string least = EndText(cost.least);
  const bool has_limit = cost.most < kInfinity;
  if (cost.least == 0 && !has_limit) return "going on can only cost";
  std::string range = fmt::format("{} to {} per second", least, EndText(cost.most));
  if (cost.least == 0) range = fmt::format("up to {} per second", EndText(cost.most));
  if (!has_limit) range = fmt::format("at least {} per second", least);
  if (cost.most == cost.least) range = least + " per second";
  if (cost.is_moderate) range += " in moderate motions";
  if (cost.least > 0 && seconds > 1) range += fmt::format(" for {} s", EndText(seconds));
  return "going on costs " + range;
}

std::string TextOf(const Interval& paid) {
  if (paid.low == 0 && paid.high == 0) return "failing costs nothing";
  if (paid.low >= 0 && paid.low == paid.high)
    return fmt::format("failing pays {}", EndText(paid.low));
  if (paid.low >= 0) return fmt::format("failing pays up to {}", EndText(paid.high));
  if (paid.low == paid.high) return fmt::format("failing costs {}", EndText(-paid.low));
  return fmt::format("failing costs at most {}", EndText(-paid.low));
}

Help MakeItCost(const CheckedTask& task, const Failure& failure, double cost) {
  double penalty = 10;
  while (penalty <= cost) penalty *= 10;
  const bool is_paid = !failure.beside.empty();
  const std::string term = is_paid ? task.terms[*failure.beside.begin()].name : "fall";
  const std::string reward = fmt::format("reward {} = -{:.0f}", term, penalty);
  Help help = fmt::format("let failing cost more than going on: `{}`", reward);
  const bool is_new = std::ranges::find(task.terms, term, &CheckedTerm::name) == task.terms.end();
  // With `after_end continue` it would be paid in one step after the other.
  if (is_new && task.ended) help.fixes = {{{failure.span.begin, failure.span.begin}, reward + " "}};
  return help;
}

}  // namespace

void WarnOfEarlyDeath(const CheckedTask& task, Diagnostics& diagnostics) {
  const std::vector<Failure> failures = FailuresOf(task);
  if (failures.empty()) return;
  const TaskBounds bounds = ComputeBounds(task, {.has_initial_params = true});
  const TaskBounds moderate =
      ComputeBounds(task, {.share_of_nominal = kModerateShare, .has_initial_params = true});
  const std::optional<Cost> cost = CostOfGoingOn(task, bounds, moderate);
  if (!cost) return;
  // What is certain until the episode is over, or what a second of motion can cost, where that is
  // known.
  const double seconds = LeastTime(task);
  const double in_a_second = cost->most < kInfinity ? cost->most : 0;
  const double to_go_on = std::max(cost->least * seconds, in_a_second);
  for (const Failure& failure : failures) {
    if (!bounds.ends_reached[failure.end] || CanGain(bounds, failure)) continue;
    const Interval paid = PaidFor(failure, bounds);
    if (paid.low < 0 && -paid.low >= to_go_on) continue;
    Report(diagnostics, code::kEarlyDeath, failure.span,
           "failing early is the best that the agent can do",
           {.note = fmt::format("{}, {}", TextOf(*cost, seconds), TextOf(paid)),
            .help = MakeItCost(task, failure, to_go_on)});
  }
}

}  // namespace compiler
