// The logs of a task: one curve for each name, whichever statements feed it.
#pragma once

#include <optional>
#include <set>

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

class LogTable {
 public:
  LogTable(const TaskScope& scope, CheckedTask& task) : scope_(scope), task_(task) {}

  // A `log` statement in an event. Reports mistakes and then returns nothing.
  std::optional<CheckedLog> Check(const LogStatement& log, const Place& place);

 private:
  uint32_t Declare(const LogStatement& log);
  void CheckReduction(const LogStatement& log, const CheckedLogValue& first) const;
  bool CheckUnit(const LogStatement& log, uint32_t index, CheckedExpression& value);

  const TaskScope& scope_;
  CheckedTask& task_;
  std::set<uint32_t> with_unit_;  // a log of nothing but literal zeros has no unit yet
};

}  // namespace compiler
