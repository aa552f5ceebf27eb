// What the statements of a task do, as facts about what they concern.
#pragma once

#include <string>
#include <vector>

#include "compiler/difference/expression_text.h"
#include "compiler/difference/task_outline.h"

namespace compiler {

class StatementOutliner {
 public:
  // Refers to all, which must outlive it.
  StatementOutliner(const CheckedTask& task, ExpressionWriter& writer, TaskOutline& outline)
      : task_(task), writer_(writer), outline_(outline) {}

  // `name`: "end_of_time_step". Where that is "start", its assignments are about the start.
  void AddEvent(const std::string& name, const CheckedEvent& event);

 private:
  void AddBlock(const CheckedBlock& block);

  void AddNode(const CheckedLet& let);
  void AddNode(const CheckedAssign& assign);
  void AddNode(const CheckedIf& branches);
  void AddNode(const CheckedFor& loop);
  void AddNode(const CheckedReward& reward);
  void AddNode(const CheckedEnd& end);
  void AddNode(const CheckedLog& log);
  void AddNode(const CheckedRequire& require);
  void AddNode(const CheckedRedraw& redraw);
  void AddNode(const CheckedNext& next);
  void AddNode(const CheckedPhaseSwitch& phases);
  void AddNode(const CheckedAdvance&) {}  // a part of what reads it
  void AddNode(const CheckedPotentialStep& step);

  // One statement, under the conditions that hold here.
  void Add(const std::string& kind, const std::string& name, const std::string& what,
           const std::string& text);

  const CheckedTask& task_;
  ExpressionWriter& writer_;
  TaskOutline& outline_;
  std::string event_;
  std::vector<std::string> conditions_;
  size_t kept_ = 0;  // local values that are kept as such, since where they are computed matters
};

// "failure \"falls\""
std::string EndName(EndKind kind, const std::string& reason);

}  // namespace compiler
