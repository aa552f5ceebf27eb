#include "compiler/bounds/early_death.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "compiler/check/report.h"
#include "compiler/check/traversal.h"

namespace compiler {
namespace {

// The sensors, params, memory and locals that an expression reads: the kind, then the index.
using Reads = std::set<std::pair<size_t, uint32_t>>;

const size_t kMemoryKind = decltype(CheckedExpression::node)(MemoryRead{}).index();

void AddReads(const CheckedExpression& expression, Reads& reads) {
  ForEachPart(expression, [&](const CheckedExpression& part) {
    const size_t kind = part.node.index();
    if (const auto* read = std::get_if<SensorRead>(&part.node)) reads.insert({kind, read->sensor});
    if (const auto* read = std::get_if<ParamRead>(&part.node)) reads.insert({kind, read->param});
    if (const auto* read = std::get_if<MemoryRead>(&part.node)) reads.insert({kind, read->memory});
    if (const auto* read = std::get_if<LocalRead>(&part.node)) reads.insert({kind, read->local});
  });
}

// Failures and plain payments, each with what the conditions around it read or set.
class PlacesUnderConditions {
 public:
  explicit PlacesUnderConditions(const CheckedTask& task) : task_(task) {
    for (const CheckedEvent& event : task.events) Search(event.body, {});
  }

  struct Failure {
    uint32_t end;
    Span span;
    Reads reads;
  };
  const std::vector<Failure>& failures() const { return failures_; }

  // Is anything paid under conditions that have to do with those of the failure?
  bool MayCost(const Failure& failure) const {
    return std::ranges::any_of(payments_, [&](const Reads& payment) {
      return std::ranges::any_of(payment,
                                 [&](const auto& read) { return failure.reads.contains(read); });
    });
  }

 private:
  void Search(const CheckedBlock& block, const Reads& conditions) {
    Reads reads = conditions;
    // What a block with an end notes down may be what is paid for elsewhere.
    for (const CheckedStatement& statement : block)
      if (const auto* assign = std::get_if<CheckedAssign>(&statement.node);
          assign && !reads.empty())
        reads.insert({kMemoryKind, assign->memory});
    for (const CheckedStatement& statement : block) {
      const auto* reward = std::get_if<CheckedReward>(&statement.node);
      if (reward != nullptr && !reward->is_rate) payments_.push_back(reads);
      const auto* end = std::get_if<CheckedEnd>(&statement.node);
      if (end != nullptr && task_.ends[end->end].kind == EndKind::kFailure)
        failures_.push_back({end->end, statement.span, reads});
      if (const auto* loop = std::get_if<CheckedFor>(&statement.node))
        for (const CheckedPass& pass : loop->passes) Search(pass.body, reads);
      if (const auto* branches = std::get_if<CheckedIf>(&statement.node)) Search(*branches, reads);
    }
  }

  void Search(const CheckedIf& branches, Reads conditions) {
    for (const CheckedIfBranch& branch : branches.branches) {
      AddReads(branch.condition, conditions);
      Search(branch.body, conditions);
    }
    Search(branches.otherwise, conditions);
  }

  const CheckedTask& task_;
  std::vector<Failure> failures_;
  std::vector<Reads> payments_;
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

bool NeverPaysMoreThanNothing(const TermBounds& term) {
  const auto is_cost = [](const std::optional<Interval>& value) {
    return !value || value->high <= 0;
  };
  return is_cost(term.rate) && is_cost(term.payment);
}

// `cost`: the term that is due in every step.
void WarnOfFreeFailures(const CheckedTask& task, const TaskBounds& bounds, const std::string& cost,
                        Diagnostics& diagnostics) {
  const PlacesUnderConditions places(task);
  std::set<uint32_t> said;  // the passes of a loop have the same places
  for (const PlacesUnderConditions::Failure& failure : places.failures()) {
    if (!bounds.ends_reached[failure.end] || places.MayCost(failure)) continue;
    if (!said.insert(failure.span.begin).second) continue;
    Report(diagnostics, code::kEarlyDeath, failure.span,
           "failing early is the best that the agent can do",
           {.note = fmt::format("`{}` costs in every step, failing costs nothing", cost),
            .help = "let the failure cost more than continuing, as in `reward fall = -10`"});
  }
}

}  // namespace

void WarnOfEarlyDeath(const CheckedTask& task, const TaskBounds& bounds, Diagnostics& diagnostics) {
  if (!std::ranges::all_of(bounds.terms, NeverPaysMoreThanNothing)) return;
  for (uint32_t i = 0; i < task.terms.size(); ++i) {
    const auto& rate = bounds.terms[i].rate;
    if (!rate || rate->high >= 0 || !IsPaidAlways(task, i)) continue;
    WarnOfFreeFailures(task, bounds, task.terms[i].name, diagnostics);
    return;
  }
}

}  // namespace compiler
