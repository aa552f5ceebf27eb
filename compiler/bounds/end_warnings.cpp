#include "compiler/bounds/end_warnings.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/check/report.h"
#include "compiler/check/traversal.h"

namespace compiler {
namespace {

// ---- An end in every step -----------------------------------------------------------------------

// When the first callback of an event runs; nothing where an end in each of them makes sense: an
// episode may consist of one action.
std::optional<std::string> FirstTime(EventKind event) {
  switch (event) {
    case EventKind::kStartOfEpisode:
    case EventKind::kStartOfAction:
    case EventKind::kStartOfTimeStep:
    case EventKind::kStartOfPhysicsStep:
      return "before the robot has moved";
    case EventKind::kEndOfTimeStep:
      return "in its first time step";
    case EventKind::kEndOfPhysicsStep:
      return "in its first physics step";
    case EventKind::kEndOfEpisode:
    case EventKind::kEndOfAction:
      break;
  }
  return std::nullopt;
}

// An end that is always reached, and the conditions around it, which always hold.
struct CertainEnd {
  Span span;
  std::vector<Span> conditions;
};

class CertainEndSearch {
 public:
  explicit CertainEndSearch(const TaskBounds& bounds) : bounds_(bounds) {}

  std::optional<CertainEnd> Find(const CheckedBlock& block) {
    for (const CheckedStatement& statement : block) {
      if (std::holds_alternative<CheckedEnd>(statement.node))
        return CertainEnd{statement.span, conditions_};
      if (const auto* loop = std::get_if<CheckedFor>(&statement.node))
        for (const CheckedPass& pass : loop->passes)
          if (auto end = Find(pass.body)) return end;
      if (const auto* branches = std::get_if<CheckedIf>(&statement.node))
        if (auto end = FindIn(branches->branches.front())) return end;
      // An episode begins in the first phase.
      if (const auto* phases = std::get_if<CheckedPhaseSwitch>(&statement.node))
        if (auto end = Find(phases->blocks.front())) return end;
    }
    return std::nullopt;
  }

 private:
  std::optional<CertainEnd> FindIn(const CheckedIfBranch& branch) {
    const auto condition =
        std::ranges::find(bounds_.conditions, branch.condition.span, &ConditionBounds::span);
    if (condition == bounds_.conditions.end() || condition->may_be_false) return std::nullopt;
    conditions_.push_back(branch.condition.span);
    auto end = Find(branch.body);
    conditions_.pop_back();
    return end;
  }

  const TaskBounds& bounds_;
  std::vector<Span> conditions_;  // around the block that is searched
};

void WarnOfCertainEnds(const CheckedTask& task, const TaskBounds& bounds,
                       Diagnostics& diagnostics) {
  for (size_t i = 0; i < task.events.size(); ++i) {
    const auto when = FirstTime(static_cast<EventKind>(i));
    if (!when) continue;
    const auto end = CertainEndSearch(bounds).Find(task.events[i].body);
    if (!end) continue;
    Explanation explanation{
        .help = "say when it is to end: `if time > 20 s { truncate_episode \"time is up\" }`"};
    for (const Span condition : end->conditions)
      explanation.labels.push_back({condition, "this is always true"});
    Report(diagnostics, code::kCertainEnd, end->span, fmt::format("every episode ends {}", *when),
           std::move(explanation));
  }
}

// ---- Paid beside an end, again and again --------------------------------------------------------

class RepeatedPaymentSearch {
 public:
  RepeatedPaymentSearch(const CheckedTask& task, Diagnostics& diagnostics)
      : task_(task), diagnostics_(diagnostics) {}

  void Search(const CheckedBlock& block, const CheckedStatement* condition) {
    const size_t outer_sets = sets_.size();
    for (const CheckedStatement& statement : block)
      if (const auto* assign = std::get_if<CheckedAssign>(&statement.node))
        sets_.push_back(assign->memory);
    Look(block, condition);
    for (const CheckedStatement& statement : block) {
      if (const auto* loop = std::get_if<CheckedFor>(&statement.node))
        for (const CheckedPass& pass : loop->passes) Search(pass.body, nullptr);
      if (const auto* branches = std::get_if<CheckedIf>(&statement.node))
        Search(*branches, statement);
      if (const auto* phases = std::get_if<CheckedPhaseSwitch>(&statement.node))
        for (const CheckedBlock& phase : phases->blocks) Search(phase, nullptr);
    }
    sets_.resize(outer_sets);
  }

 private:
  void Search(const CheckedIf& branches, const CheckedStatement& statement) {
    const size_t outer_reads = reads_.size();
    const bool is_single = branches.branches.size() == 1 && branches.otherwise.empty();
    for (const CheckedIfBranch& branch : branches.branches) {
      ForEachPart(branch.condition, [&](const CheckedExpression& part) {
        if (const auto* read = std::get_if<MemoryRead>(&part.node)) reads_.push_back(read->memory);
      });
      Search(branch.body, is_single ? &statement : nullptr);
    }
    Search(branches.otherwise, nullptr);
    reads_.resize(outer_reads);
  }

  // `condition`: the `if` whose only block this is, if it is such a one.
  void Look(const CheckedBlock& block, const CheckedStatement* condition) {
    const auto end = std::ranges::find_if(block, [](const CheckedStatement& statement) {
      return std::holds_alternative<CheckedEnd>(statement.node);
    });
    if (end == block.end() || IsGuarded()) return;
    for (const CheckedStatement& statement : block) {
      const auto* reward = std::get_if<CheckedReward>(&statement.node);
      const bool is_paid = reward != nullptr && !reward->is_rate;
      if (!is_paid || !said_.insert(statement.span.begin).second) continue;
      Help help = "pay it once: `once per episode if ...`";
      if (condition != nullptr)
        help.fixes = {{{condition->span.begin, condition->span.begin}, "once per episode "}};
      Report(diagnostics_, code::kRepeatedPayment, statement.span,
             fmt::format("`{}` is paid again in each step until the episode is over",
                         task_.terms[reward->term].name),
             {.help = std::move(help),
              .labels = {{end->span, "after which callbacks run on: `after_end continue`"}}});
    }
  }

  // Does a condition around this block read what a block around it sets, as in `once`?
  bool IsGuarded() const {
    return std::ranges::any_of(
        reads_, [&](uint32_t memory) { return std::ranges::find(sets_, memory) != sets_.end(); });
  }

  const CheckedTask& task_;
  Diagnostics& diagnostics_;
  std::vector<uint32_t> reads_;  // by the conditions around the block that is searched
  std::vector<uint32_t> sets_;   // by it and the blocks around it
  std::set<uint32_t> said_;
};

}  // namespace

void WarnOfEnds(const CheckedTask& task, const TaskBounds& bounds, Diagnostics& diagnostics) {
  WarnOfCertainEnds(task, bounds, diagnostics);
  if (task.ended) return;
  RepeatedPaymentSearch search(task, diagnostics);
  for (size_t i = static_cast<size_t>(EventKind::kStartOfTimeStep); i < task.events.size(); ++i)
    search.Search(task.events[i].body, nullptr);
}

}  // namespace compiler
