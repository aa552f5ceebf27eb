#include "compiler/bounds/dependence.h"

#include <algorithm>
#include <utility>

#include "compiler/check/traversal.h"

namespace compiler {
namespace {

using MemorySet = std::set<uint32_t>;

// What something depends on directly, through the local values of its event as well.
struct Reads {
  MemorySet memory;
  std::set<uint32_t> sensors;
  bool reward = false;  // the sum of this callback's terms

  void Add(const Reads& more) {
    memory.insert(more.memory.begin(), more.memory.end());
    sensors.insert(more.sensors.begin(), more.sensors.end());
    reward = reward || more.reward;
  }
};

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
    found_.sensors.resize(task.memory.size());
    for (uint32_t i = 0; i < task.memory.size(); ++i) {
      found_.sensed.insert(i);
      found_.accumulated.insert(i);
    }
    for (const CheckedGoal& goal : task.goals) found_.sensed.erase(goal.memory);
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
  // `conditions`: what decides whether this block runs.
  void Search(const CheckedBlock& block, const Reads& conditions, bool is_conditional) {
    for (const CheckedStatement& statement : block) {
      if (const auto* let = std::get_if<CheckedLet>(&statement.node)) {
        locals_[let->local] = ReadBy(let->value);
      } else if (const auto* assign = std::get_if<CheckedAssign>(&statement.node)) {
        Add(*assign, conditions, is_conditional);
      } else if (const auto* advance = std::get_if<CheckedAdvance>(&statement.node)) {
        Add(*advance);
      } else if (const auto* branches = std::get_if<CheckedIf>(&statement.node)) {
        Reads inside = conditions;
        for (const CheckedIfBranch& branch : branches->branches) {
          inside.Add(ReadBy(branch.condition));
          Search(branch.body, inside, true);
        }
        Search(branches->otherwise, inside, true);
      } else if (const auto* loop = std::get_if<CheckedFor>(&statement.node)) {
        for (const CheckedPass& pass : loop->passes) Search(pass.body, conditions, is_conditional);
      } else if (const auto* phases = std::get_if<CheckedPhaseSwitch>(&statement.node)) {
        Reads inside = conditions;
        inside.memory.insert(task_.phase_memory.present);
        for (const CheckedBlock& phase : phases->blocks) Search(phase, inside, true);
      } else if (std::holds_alternative<CheckedNext>(statement.node)) {
        for (const uint32_t memory : {task_.phase_memory.present, task_.phase_memory.time})
          AddChange(memory, conditions);
      } else if (const auto* reward = std::get_if<CheckedReward>(&statement.node)) {
        Reads reads = ReadBy(reward->value);
        reads.Add(conditions);
        found_.rewards.push_back({statement.span, std::move(reads.memory)});
      } else if (const auto* step = std::get_if<CheckedPotentialStep>(&statement.node)) {
        if (step->moment == CheckedPotentialStep::kAction)
          found_.rewards.push_back({statement.span, ReadBy(step->value).memory});
      } else if (std::holds_alternative<CheckedEnd>(statement.node)) {
        found_.ends.push_back({statement.span, conditions.memory});
      }
    }
  }

  void AddSources(uint32_t memory, const Reads& reads) {
    found_.sources[memory].insert(reads.memory.begin(), reads.memory.end());
    found_.sensors[memory].insert(reads.sensors.begin(), reads.sensors.end());
  }

  void Add(const CheckedAssign& assign, const Reads& conditions, bool is_conditional) {
    AddSources(assign.memory, conditions);
    const Reads read = ReadBy(assign.value);
    AddSources(assign.memory, read);
    const bool is_sensed =
        assign.op == AssignOperator::kSet && !is_conditional && read.memory.empty() && !read.reward;
    if (!is_sensed) found_.sensed.erase(assign.memory);
    if (!IsSum(assign)) found_.accumulated.erase(assign.memory);
    is_set_.insert(assign.memory);
  }

  // A phase begins under these conditions.
  void AddChange(uint32_t memory, const Reads& conditions) {
    AddSources(memory, conditions);
    found_.sensed.erase(memory);
    found_.accumulated.erase(memory);
  }

  void Add(const CheckedAdvance& advance) {
    const CheckedTimeFunction& function = task_.time_functions[advance.function];
    const Reads read = ReadBy(advance.value);
    AddSources(function.value, read);
    const bool is_sensed = std::ranges::all_of(
        read.memory, [&](uint32_t each) { return IsTimed(each) && found_.sensed.contains(each); });
    if (Accumulates(function.function) || !is_sensed) found_.sensed.erase(function.value);
  }

  bool IsTimed(uint32_t memory) const {
    return std::ranges::find(task_.time_functions, memory, &CheckedTimeFunction::value) !=
           task_.time_functions.end();
  }

  // What the others give follows from two moments.
  static bool Accumulates(TimeFunction function) {
    return function == TimeFunction::kSmooth || function == TimeFunction::kHeld ||
           function == TimeFunction::kSince;
  }

  Reads ReadBy(const CheckedExpression& expression) {
    Reads reads;
    ForEachPart(expression, [&](const CheckedExpression& part) {
      if (const auto* read = std::get_if<MemoryRead>(&part.node)) reads.memory.insert(read->memory);
      if (const auto* read = std::get_if<SensorRead>(&part.node))
        reads.sensors.insert(read->sensor);
      if (std::holds_alternative<RewardSoFar>(part.node)) reads.reward = true;
      if (const auto* local = std::get_if<LocalRead>(&part.node)) reads.Add(locals_[local->local]);
    });
    return reads;
  }

  const CheckedTask& task_;
  Dependence found_;
  std::vector<Reads> locals_;  // of the event: what each local was computed from
  MemorySet is_set_;
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
