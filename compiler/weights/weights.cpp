#include "compiler/weights/weights.h"

#include <algorithm>
#include <utility>

#include "compiler/check/traversal.h"
#include "compiler/check/unit.h"
#include "compiler/weights/scaling.h"

namespace compiler {
namespace {

// Follows one param through all events of a task.
class ParamSearch {
 public:
  ParamSearch(const CheckedTask& task, uint32_t param) : task_(task), scaling_(task, param) {
    for (const CheckedMemory& memory : task.memory)
      reads_.memory.push_back(InMemory(scaling_.Of(memory.initial, {})));
  }

  ParamUse Search() {
    // What one event puts into memory, another reads.
    do {
      has_changed_memory_ = false;
      SearchOnce();
    } while (has_changed_memory_);
    SearchStart();
    ParamUse use{.changes_course = changes_course_};
    if (std::ranges::find(terms_, Scaling::kOther) != terms_.end()) return use;
    for (uint32_t i = 0; i < terms_.size(); ++i)
      if (terms_[i] == Scaling::kProportional) use.scales.push_back(i);
    return use;
  }

 private:
  // Of where the robot begins, all follows.
  void SearchStart() {
    reads_.locals.assign(task_.start.block.locals.size(), {});
    ForEachStatement(task_.start.block.body, [&](const CheckedStatement& statement) {
      ForEachExpression(statement, [&](const CheckedExpression& value) {
        changes_course_ |= !IsIndependent(Of(value));
      });
    });
  }

  void SearchOnce() {
    terms_.assign(task_.terms.size(), Scaling::kZero);
    for (const CheckedEvent& event : task_.events) {
      reads_.locals.assign(event.locals.size(), {});
      reads_.reward_so_far = Scaling::kIndependent;
      Search(event.body, false);
    }
  }

  // Memory lives through callbacks in which its param may be set anew: it is never proportional.
  static Scaling InMemory(Scaling value) {
    return IsIndependent(value) ? Scaling::kIndependent : Scaling::kOther;
  }

  Scaling Of(const CheckedExpression& expression) { return scaling_.Of(expression, reads_); }

  // `is_decided`: whether the block runs depends on the param.
  void Search(const CheckedBlock& block, bool is_decided) {
    for (const CheckedStatement& statement : block)
      std::visit([&](const auto& node) { Search(node, is_decided); }, statement.node);
  }

  void Search(const CheckedLet& let, bool) { reads_.locals[let.local] = Of(let.value); }

  void Search(const CheckedAssign& assign, bool is_decided) {
    if (is_decided || !IsIndependent(Of(assign.value))) Change(assign.memory);
  }

  void Change(uint32_t memory) {
    has_changed_memory_ |= std::exchange(reads_.memory[memory], Scaling::kOther) != Scaling::kOther;
  }

  void Search(const CheckedIf& branches, bool is_decided) {
    for (const CheckedIfBranch& branch : branches.branches) {
      is_decided |= !IsIndependent(Of(branch.condition));
      Search(branch.body, is_decided);
    }
    Search(branches.otherwise, is_decided);
  }

  void Search(const CheckedFor& loop, bool is_decided) {
    for (const CheckedPass& pass : loop.passes) Search(pass.body, is_decided);
  }

  void Search(const CheckedReward& reward, bool is_decided) {
    const Scaling paid = is_decided ? Scaling::kOther : Of(reward.value);
    terms_[reward.term] = Sum(terms_[reward.term], paid);
    if (!IsIndependent(paid)) reads_.reward_so_far = Scaling::kOther;
  }

  void Search(const CheckedEnd&, bool is_decided) { changes_course_ |= is_decided; }

  // The trainer ends the episode where it does not hold.
  void Search(const CheckedRequire& require, bool is_decided) {
    changes_course_ |= is_decided || !IsIndependent(Of(require.condition));
  }

  void Search(const CheckedRedraw& redraw, bool is_decided) {
    const CheckedGoal& goal = task_.goals[redraw.goal];
    is_decided |= goal.interval && !IsIndependent(Of(goal.interval->length));
    if (is_decided || !IsIndependent(Of(goal.value))) Change(goal.memory);
  }

  void Search(const CheckedNext&, bool is_decided) {
    if (!is_decided) return;
    Change(task_.phase_memory.present);
    Change(task_.phase_memory.time);
  }

  void Search(const CheckedPhaseSwitch& phases, bool is_decided) {
    is_decided |= !IsIndependent(reads_.memory[task_.phase_memory.present]);
    for (const CheckedBlock& phase : phases.blocks) Search(phase, is_decided);
  }

  void Search(const CheckedAdvance& advance, bool is_decided) {
    const bool is_independent = IsIndependent(Of(advance.value)) &&
                                (!advance.duration || IsIndependent(Of(*advance.duration)));
    if (is_decided || !is_independent) Change(task_.time_functions[advance.function].value);
  }

  // The memory in it is of the same potential, so all that it pays is proportional like the value.
  void Search(const CheckedPotentialStep& step, bool) {
    const uint32_t term = task_.potentials[step.potential].term;
    const Scaling paid = Of(step.value);
    terms_[term] = Sum(terms_[term], paid);
    if (!IsIndependent(paid)) reads_.reward_so_far = Scaling::kOther;
  }

  // Nothing reads a log.
  void Search(const CheckedLog&, bool) {}

  const CheckedTask& task_;
  ExpressionScaling scaling_;
  ScalingOfReads reads_{};
  std::vector<Scaling> terms_{};
  bool has_changed_memory_ = false;
  bool changes_course_ = false;
};

bool CanBeWeight(const CheckedParam& param) {
  return param.type.scalar == Scalar::kReal && !IsAngle(param.unit);
}

// The param that scales the fewest terms besides `term`, since it says most about this one.
std::optional<uint32_t> WeightOf(uint32_t term, const std::vector<ParamUse>& params) {
  std::optional<uint32_t> weight;
  for (uint32_t i = 0; i < params.size(); ++i) {
    const std::vector<uint32_t>& scales = params[i].scales;
    if (!std::ranges::binary_search(scales, term)) continue;
    if (!weight || scales.size() < params[*weight].scales.size()) weight = i;
  }
  return weight;
}

}  // namespace

Weights FindWeights(const CheckedTask& task) {
  Weights weights;
  for (uint32_t i = 0; i < task.params.size(); ++i) {
    weights.params.push_back(ParamSearch(task, i).Search());
    if (!CanBeWeight(task.params[i])) weights.params.back().scales.clear();
  }
  for (uint32_t i = 0; i < task.terms.size(); ++i)
    weights.terms.push_back(WeightOf(i, weights.params));
  return weights;
}

}  // namespace compiler
