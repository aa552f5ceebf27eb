#include "compiler/check/transitions.h"

#include <algorithm>
#include <utility>

namespace compiler {
namespace {

// The ways out of one phase.
class TransitionSearch {
 public:
  TransitionSearch(const CheckedPhase& phase, uint32_t from, std::vector<Transition>& found)
      : phase_(phase), from_(from), found_(found) {}

  void Search(const CheckedBlock& block, Transition way) {
    for (const CheckedStatement& statement : block)
      if (const auto* reward = std::get_if<CheckedReward>(&statement.node))
        if (!reward->is_rate) way.payments.push_back(reward);
    for (const CheckedStatement& statement : block) {
      if (const auto* next = std::get_if<CheckedNext>(&statement.node))
        Add(*next, statement.span, way);
      if (const auto* loop = std::get_if<CheckedFor>(&statement.node))
        for (const CheckedPass& pass : loop->passes) Search(pass.body, way);
      if (const auto* branches = std::get_if<CheckedIf>(&statement.node)) Search(*branches, way);
    }
  }

 private:
  void Search(const CheckedIf& branches, Transition way) {
    for (const CheckedIfBranch& branch : branches.branches) {
      Transition inside = way;
      inside.conditions.push_back({&branch.condition, true});
      Search(branch.body, std::move(inside));
      way.conditions.push_back({&branch.condition, false});
    }
    Search(branches.otherwise, std::move(way));
  }

  void Add(const CheckedNext& next, Span span, Transition way) {
    if (std::ranges::find(found_, span, &Transition::span) != found_.end()) return;
    way.from = from_;
    way.to = next.phase;
    way.span = span;
    if (phase_.limit && phase_.limit->span == span) {
      way.is_limit = true;
      way.conditions.clear();
    }
    found_.push_back(std::move(way));
  }

  const CheckedPhase& phase_;
  uint32_t from_;
  std::vector<Transition>& found_;
};

}  // namespace

const CheckedPhaseSwitch* FindPhaseSwitch(const CheckedTask& task) {
  const CheckedEvent& event = task.events[static_cast<size_t>(EventKind::kEndOfTimeStep)];
  for (const CheckedStatement& statement : event.body)
    if (const auto* phases = std::get_if<CheckedPhaseSwitch>(&statement.node)) return phases;
  return nullptr;
}

std::vector<Transition> TransitionsOf(const CheckedTask& task) {
  std::vector<Transition> found;
  const CheckedPhaseSwitch* phases = FindPhaseSwitch(task);
  if (phases == nullptr) return found;
  for (uint32_t i = 0; i < phases->blocks.size(); ++i)
    TransitionSearch(task.phases[i], i, found).Search(phases->blocks[i], {});
  return found;
}

}  // namespace compiler
