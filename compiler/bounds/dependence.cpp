#include "compiler/bounds/dependence.h"

#include <algorithm>
#include <utility>

#include "compiler/check/traversal.h"

namespace compiler {
namespace {

using MemorySet = std::set<uint32_t>;

bool IsSum(const CheckedAssign& assign) {
  if (assign.op == AssignOperator::kAdd || assign.op == AssignOperator::kSubtract) return true;
  const auto* sum = std::get_if<CheckedBinary>(&assign.value.node);
  if (assign.op != AssignOperator::kSet || sum == nullptr) return false;
  if (sum->op != BinaryOperator::kAdd && sum->op != BinaryOperator::kSubtract) return false;
  const auto is_itself = [&](const CheckedExpression& operand) {
    const auto* read = std::get_if<MemoryRead>(&operand.node);
    return read != nullptr && read->memory == assign.memory;
  };
  return is_itself(*sum->left) || (sum->op == BinaryOperator::kAdd && is_itself(*sum->right));
}

class DependenceSearch {
 public:
  explicit DependenceSearch(const CheckedTask& task) : task_(task) {
    found_.sources.resize(task.memory.size());
    for (uint32_t i = 0; i < task.memory.size(); ++i) {
      found_.sensed.insert(i);
      found_.accumulated.insert(i);
    }
  }

  Dependence Search() {
    for (const CheckedEvent& event : task_.events) {
      locals_.assign(event.locals.size(), {});
      Search(event.body, {}, false);
    }
    std::erase_if(found_.accumulated, [&](uint32_t memory) { return !is_set_.contains(memory); });
    return std::move(found_);
  }

 private:
  // `conditions`: the memory that decides whether this block runs.
  void Search(const CheckedBlock& block, const MemorySet& conditions, bool is_conditional) {
    for (const CheckedStatement& statement : block) {
      if (const auto* let = std::get_if<CheckedLet>(&statement.node)) {
        locals_[let->local] = ReadBy(let->value);
      } else if (const auto* assign = std::get_if<CheckedAssign>(&statement.node)) {
        Add(*assign, conditions, is_conditional);
      } else if (const auto* branches = std::get_if<CheckedIf>(&statement.node)) {
        MemorySet inside = conditions;
        for (const CheckedIfBranch& branch : branches->branches) {
          inside.merge(ReadBy(branch.condition));
          Search(branch.body, inside, true);
        }
        Search(branches->otherwise, inside, true);
      } else if (const auto* loop = std::get_if<CheckedFor>(&statement.node)) {
        for (const CheckedPass& pass : loop->passes) Search(pass.body, conditions, is_conditional);
      } else if (const auto* phases = std::get_if<CheckedPhaseSwitch>(&statement.node)) {
        MemorySet inside = conditions;
        inside.insert(task_.phase_memory.present);
        for (const CheckedBlock& phase : phases->blocks) Search(phase, inside, true);
      } else if (std::holds_alternative<CheckedNext>(statement.node)) {
        for (const uint32_t memory : {task_.phase_memory.present, task_.phase_memory.time})
          AddChange(memory, conditions);
      } else if (const auto* reward = std::get_if<CheckedReward>(&statement.node)) {
        MemorySet memory = ReadBy(reward->value);
        memory.insert(conditions.begin(), conditions.end());
        found_.rewards.push_back({statement.span, std::move(memory)});
      } else if (const auto* step = std::get_if<CheckedPotentialStep>(&statement.node)) {
        if (step->moment == CheckedPotentialStep::kAction)
          found_.rewards.push_back({statement.span, ReadBy(step->value)});
      } else if (std::holds_alternative<CheckedEnd>(statement.node)) {
        found_.ends.push_back({statement.span, conditions});
      }
    }
  }

  void Add(const CheckedAssign& assign, const MemorySet& conditions, bool is_conditional) {
    MemorySet& sources = found_.sources[assign.memory];
    sources.insert(conditions.begin(), conditions.end());
    const MemorySet read = ReadBy(assign.value);
    sources.insert(read.begin(), read.end());
    const bool is_sensed =
        assign.op == AssignOperator::kSet && !is_conditional && read.empty() && !reads_reward_;
    if (!is_sensed) found_.sensed.erase(assign.memory);
    if (!IsSum(assign)) found_.accumulated.erase(assign.memory);
    is_set_.insert(assign.memory);
  }

  // A phase begins under these conditions.
  void AddChange(uint32_t memory, const MemorySet& conditions) {
    found_.sources[memory].insert(conditions.begin(), conditions.end());
    found_.sensed.erase(memory);
    found_.accumulated.erase(memory);
  }

  MemorySet ReadBy(const CheckedExpression& expression) {
    MemorySet memory;
    reads_reward_ = false;
    ForEachPart(expression, [&](const CheckedExpression& part) {
      if (const auto* read = std::get_if<MemoryRead>(&part.node)) memory.insert(read->memory);
      if (std::holds_alternative<RewardSoFar>(part.node)) reads_reward_ = true;
      if (const auto* local = std::get_if<LocalRead>(&part.node))
        memory.insert(locals_[local->local].begin(), locals_[local->local].end());
    });
    return memory;
  }

  const CheckedTask& task_;
  Dependence found_;
  std::vector<MemorySet> locals_;  // of the event: what each local was computed from
  MemorySet is_set_;
  bool reads_reward_ = false;  // the expression looked at last
};

}  // namespace

Dependence DependenceOf(const CheckedTask& task) { return DependenceSearch(task).Search(); }

std::set<uint32_t> WithSources(const Dependence& dependence, std::set<uint32_t> memory) {
  std::vector<uint32_t> open(memory.begin(), memory.end());
  while (!open.empty()) {
    const uint32_t next = open.back();
    open.pop_back();
    for (const uint32_t source : dependence.sources[next])
      if (memory.insert(source).second) open.push_back(source);
  }
  return memory;
}

}  // namespace compiler
