// The names of phases where they are used, and what a task reads of them: `phase == lift` and
// `phase_time`.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "compiler/check/checked_task.h"
#include "compiler/check/symbol_table.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

inline constexpr std::string_view kPhase = "phase";
inline constexpr std::string_view kPhaseTime = "phase_time";

// Is it one of these two, which a task with phases does not declare itself?
inline bool ComesWithPhases(SymbolKind kind) {
  return kind == SymbolKind::kPhase || kind == SymbolKind::kPhaseTime;
}

// The phase of this name, among those of the task. Reports and returns nothing where there is none.
std::optional<uint32_t> FindPhase(const Identifier& name, const TaskScope& scope);

// Is a side of the operator the present phase?
bool ComparesPhase(const BinaryExpression& binary, const TaskScope& scope);
// Such a comparison, `phase == lift`. Reports and returns nothing where it is wrong.
std::optional<CheckedExpression> CheckPhaseComparison(const BinaryExpression& binary, Span span,
                                                      const Place& place, const TaskScope& scope);

// `phase` alone, as the learner sees it: a condition for each phase, in their order. Nothing where
// it is anything else, or there are no phases.
std::optional<CheckedExpression> PhaseFlags(const Expression& expression, const TaskScope& scope);

// Reports that the present phase stands where a value is needed.
void ReportPhaseAsValue(Span span, const TaskScope& scope);

// Reports that something is declared by a name that phases bring with them, as `read`.
void ReportNameOfPhases(const Identifier& name, const Symbol& read, const TaskScope& scope);

// Reports `phase` or `phase_time` in a task without phases. False: it is none of them, or there are
// phases.
bool ReportMissingPhases(const Identifier& name, const TaskScope& scope);

}  // namespace compiler
