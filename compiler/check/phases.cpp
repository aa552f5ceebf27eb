#include "compiler/check/phases.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/check/conversion.h"
#include "compiler/check/copy_checked.h"
#include "compiler/check/expressions.h"
#include "compiler/check/fold.h"
#include "compiler/check/hidden_memory.h"
#include "compiler/check/names.h"
#include "compiler/check/phase_names.h"
#include "compiler/check/report.h"
#include "compiler/check/statements.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

constexpr Unit kTimeInPhase{.second = 1};

std::vector<const PhaseDeclaration*> PhasesIn(const SyntaxTree& tree) {
  std::vector<const PhaseDeclaration*> phases;
  for (const Declaration& declaration : tree.declarations)
    if (const auto* phase = std::get_if<PhaseDeclaration>(&declaration.node))
      phases.push_back(phase);
  return phases;
}

// `phase` or `phase_time`, which the first phase brings with it.
void DeclareRead(std::string_view name, SymbolKind kind, uint32_t memory, Span first,
                 TaskScope& scope, const CheckedTask& task) {
  const Identifier declared{std::string(name), first};
  const CheckedMemory& read = task.memory[memory];
  const Symbol symbol{
      .kind = kind, .span = first, .index = memory, .type = read.type, .unit = read.unit};
  if (IsTaken(declared, scope) || scope.symbols.Declare(declared.text, symbol)) return;
  ReportNameOfPhases({declared.text, scope.symbols.Find(name)->span}, symbol, scope);
}

// How long a phase may last.
class LimitCheck {
 public:
  LimitCheck(const PhaseLimit& limit, const CheckedPhase& phase, const CheckedTask& task,
             const TaskScope& scope)
      : limit_(limit), phase_(phase), task_(task), scope_(scope) {}

  std::optional<CheckedPhase::Limit> Check() const {
    const auto otherwise = FindPhase(limit_.otherwise, scope_);
    auto time = CheckExpression(limit_.time, {Place::kEvent, EventKind::kEndOfTimeStep}, scope_);
    if (!time) return std::nullopt;
    if (!IsParam(*time) && !ValueOf(*time))
      return Wrong(time->span, "the time must be a constant or a param");
    time =
        ConvertTo({std::move(*time), &limit_.time}, kRealType, kTimeInPhase,
                  fmt::format("the time for which `{}` may last", phase_.name), scope_.diagnostics);
    if (!time || !IsPossible(*time) || !otherwise) return std::nullopt;
    return CheckedPhase::Limit{std::move(*time), *otherwise,
                               Cover(limit_.time.span, limit_.otherwise.span)};
  }

 private:
  static bool IsParam(const CheckedExpression& time) {
    return std::holds_alternative<ParamRead>(time.node);
  }

  bool IsPossible(const CheckedExpression& time) const {
    if (!IsParam(time)) {
      if (*ValueOf(time) > 0) return true;
      Wrong(time.span, "a phase lasts for a while");
      return false;
    }
    const CheckedParam& param = task_.params[std::get<ParamRead>(time.node).param];
    if (param.minimum >= 0 && !std::isinf(param.maximum)) return true;
    Wrong(time.span, std::isinf(param.maximum) ? "nothing says how long this can become"
                                               : "a phase never lasts for a negative time");
    return false;
  }

  std::nullopt_t Wrong(Span span, std::string message) const {
    Report(scope_.diagnostics, code::kBadLimit, span, std::move(message),
           {.help = "write a time such as `3 s`, or a param with a range: `param patience: real "
                    "[s] = 3 s in 1 s .. 10 s`"});
    return std::nullopt;
  }

  const PhaseLimit& limit_;
  const CheckedPhase& phase_;
  const CheckedTask& task_;
  const TaskScope& scope_;
};

CheckedExpressionPtr Time(Span span, decltype(CheckedExpression::node) node) {
  return std::make_unique<CheckedExpression>(
      CheckedExpression{span, kRealType, kTimeInPhase, std::move(node)});
}

// `if limit - phase_time < 0.5 * time_step { next OTHER }`: at the step that ends nearest to the
// limit.
CheckedStatement EndAtLimit(const CheckedPhase::Limit& limit, const CheckedTask& task) {
  const Span span = limit.span;
  CheckedBinary left{BinaryOperator::kSubtract,
                     std::make_unique<CheckedExpression>(CopyOf(limit.time)),
                     Time(span, MemoryRead{task.phase_memory.time})};
  CheckedBinary half{
      BinaryOperator::kMultiply,
      std::make_unique<CheckedExpression>(CheckedExpression{span, kRealType, {}, Constant{0.5}}),
      Time(span, TimeStep{})};
  CheckedBinary is_over{BinaryOperator::kLess, Time(span, std::move(left)),
                        Time(span, std::move(half))};
  CheckedBlock next;
  next.push_back({span, CheckedNext{limit.otherwise}});
  CheckedIf check;
  check.branches.push_back(
      {{span, ScalarType(Scalar::kBool), {}, std::move(is_over)}, std::move(next)});
  return {span, std::move(check)};
}

}  // namespace

void DeclarePhases(const SyntaxTree& tree, TaskScope& scope, CheckedTask& task) {
  for (const PhaseDeclaration* phase : PhasesIn(tree)) {
    const auto first = std::ranges::find(task.phases, phase->name.text, &CheckedPhase::name);
    if (first == task.phases.end()) {
      scope.phases.push_back(phase->name.text);
    } else {
      Report(scope.diagnostics, code::kRepeatedName, phase->name.span,
             fmt::format("there is already a phase `{}`", phase->name.text),
             {.labels = {{first->span, "first declared here"}}});
    }
    NoteReference(phase->name, ReferenceKind::kPhase, scope);
    task.phases.push_back({.name = phase->name.text, .doc = phase->doc, .span = phase->name.span});
  }
  if (task.phases.empty()) return;
  const Span first = task.phases.front().span;
  PhaseMemory& memory = task.phase_memory;
  memory.present = AddHiddenMemory("phase#", ScalarType(Scalar::kInt), {}, MemoryScope::kPerEpisode,
                                   first, task);
  memory.time = AddHiddenMemory(std::string(kPhaseTime), kRealType, kTimeInPhase,
                                MemoryScope::kPerEpisode, first, task);
  DeclareRead(kPhase, SymbolKind::kPhase, memory.present, first, scope, task);
  DeclareRead(kPhaseTime, SymbolKind::kPhaseTime, memory.time, first, scope, task);
}

void CheckPhases(const SyntaxTree& tree, LogTable& logs, TaskScope& scope, CheckedTask& task) {
  if (task.phases.empty()) return;
  CheckedPhaseSwitch phases;
  for (const PhaseDeclaration* declared : PhasesIn(tree)) {
    CheckedPhase& phase = task.phases[phases.blocks.size()];
    CheckedBlock body = CheckPhaseBlock(*declared, logs, scope, task);
    if (declared->limit) phase.limit = LimitCheck(*declared->limit, phase, task, scope).Check();
    if (phase.limit) body.push_back(EndAtLimit(*phase.limit, task));
    phases.blocks.push_back(std::move(body));
  }
  CheckedEvent& event = task.events[static_cast<size_t>(EventKind::kEndOfTimeStep)];
  const Span first = task.phases.front().span;
  if (!std::exchange(event.is_declared, true)) event.span = first;
  event.body.push_back({first, std::move(phases)});
}

void AddPhaseClock(CheckedTask& task) {
  if (task.phases.empty()) return;
  const Span first = task.phases.front().span;
  CheckedBlock& body = task.events[static_cast<size_t>(EventKind::kEndOfTimeStep)].body;
  CheckedAssign count{task.phase_memory.time,
                      {},
                      AssignOperator::kAdd,
                      {first, kRealType, kTimeInPhase, TimeStep{}}};
  body.insert(body.begin(), CheckedStatement{first, std::move(count)});
}

}  // namespace compiler
