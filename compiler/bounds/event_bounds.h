// What one callback makes of the values it finds.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/bounds/bounds.h"
#include "compiler/bounds/values.h"
#include "compiler/check/checked_task.h"

namespace compiler {

class EventBounds {
 public:
  // `found`: where to note what can happen; null: nowhere. Both must outlive this.
  EventBounds(const CheckedTask& task, TaskBounds* found) : task_(task), found_(found) {}

  // The values after the callback that starts with these.
  Values Run(const CheckedEvent& event, Values before);

 private:
  // Nothing: this place is never reached.
  using Reached = std::optional<Values>;

  void Run(const CheckedBlock& block, Reached& values);
  // These stand in a place that is reached.
  void Run(const CheckedLet& let, Reached& values);
  void Run(const CheckedAssign& assign, Reached& values);
  void Run(const CheckedIf& branches, Reached& values);
  void Run(const CheckedFor& loop, Reached& values);
  void Run(const CheckedReward& reward, Reached& values);
  void Run(const CheckedEnd& end, Reached& values);
  void Run(const CheckedLog& log, Reached& values);
  void Run(const CheckedRequire& require, Reached& values);
  void Run(const CheckedRedraw& redraw, Reached& values);
  void Run(const CheckedNext& next, Reached& values);
  void Run(const CheckedPhaseSwitch& phases, Reached& values);
  void Run(const CheckedAdvance& advance, Reached& values);
  void Run(const CheckedPotentialStep& step, Reached& values);

  void NotePotential(const CheckedPotentialStep& step, const Interval& value,
                     const Values& values) const;
  bool Assume(const CheckedExpression& condition, bool truth, Values& values) const;
  void FindDomainsLeft(const CheckedExpression& expression, const Values& values) const;
  void Note(const CheckedExpression& condition, bool may_be_true, bool may_be_false,
            const Values& values);
  void NoteOperands(const CheckedExpression& condition, const Values& values,
                    ConditionBounds& bounds) const;

  const CheckedTask& task_;
  TaskBounds* found_;
  // For each local, where its `let` was reached: what it was computed from, or null where that may
  // have changed since; and why it has no bounds.
  std::vector<const CheckedExpression*> definitions_;
  std::vector<std::vector<Cause>> local_causes_;
  std::map<std::pair<uint32_t, uint32_t>, size_t> conditions_;  // by place
};

}  // namespace compiler
