#include "compiler/check/assignment.h"

#include <utility>
#include <vector>

#include "compiler/check/conversion.h"
#include "compiler/check/draws.h"
#include "compiler/check/expressions.h"
#include "compiler/check/names.h"
#include "compiler/check/operators.h"
#include "compiler/check/report.h"
#include "compiler/check/starts.h"
#include "compiler/check/target.h"
#include "compiler/check/type.h"
#include "compiler/check/unit.h"
#include "compiler/syntax/foreign_words.h"

namespace compiler {
namespace {

// `done = true`: other languages end an episode by setting a flag. False: it is none of these.
bool ReportEndByFlag(const AssignStatement& assign, const TaskScope& scope) {
  const Identifier& name = assign.target.name;
  const ForeignWord* foreign = FindForeign(ForeignPlace::kStatement, name.text);
  const bool is_end =
      foreign != nullptr && foreign->instead.find("_episode") != std::string_view::npos;
  if (!is_end || scope.symbols.Find(name.text) != nullptr || scope.refused.contains(name.text))
    return false;
  const auto* value = std::get_if<BoolLiteral>(&assign.value.node);
  Help help = std::string(foreign->help);
  if (value != nullptr && value->value && assign.op == AssignOperator::kSet)
    help.fixes = {{Cover(assign.target.span, assign.value.span),
                   fmt::format("{} \"{}\"", foreign->instead, name.text)}};
  Report(scope.diagnostics, code::kUnknownName, name.span,
         fmt::format("there is nothing called `{}`", name.text), {.help = std::move(help)});
  return true;
}

// `phase = lift`. False: it is no such assignment.
bool ReportAssignedPhase(const AssignStatement& assign, const TaskScope& scope) {
  const Symbol* symbol = scope.symbols.Find(assign.target.name.text);
  if (symbol == nullptr || symbol->kind != SymbolKind::kPhase) return false;
  const auto* phase = std::get_if<NameExpression>(&assign.value.node);
  Help help = fmt::format("say which one comes next, in the block of a phase: `next {}`",
                          phase != nullptr ? phase->name.text : "NAME");
  if (phase != nullptr)
    help.fixes = {{Cover(assign.target.span, assign.value.span), "next " + phase->name.text}};
  Report(scope.diagnostics, code::kNotAssignable, assign.target.span,
         "`phase` is the present phase and cannot be set by the task", {.help = std::move(help)});
  return true;
}

// What an assignment sets: a memory, named by so many names.
struct Assigned {
  uint32_t memory = 0;
  Type type{};
  Unit unit{};
  size_t length = 1;
};

// Of a start. Reports and returns nothing where the target is no part of one.
std::optional<Assigned> FindStartValue(const AssignStatement& assign, const Place& place,
                                       const TaskScope& scope, const CheckedTask& task) {
  const std::vector<Identifier> path = PathOf(assign.target);
  if (const auto found = place.start->Find(path)) {
    const CheckedMemory& memory = task.memory[found->memory];
    return Assigned{found->memory, memory.type, memory.unit, found->length};
  }
  const Symbol* symbol = FindSymbol(path.front(), scope);
  if (symbol == nullptr && !scope.sensors.IsRoot(path.front().text)) {
    ReportUnknownName(path.front(), scope);
    return std::nullopt;
  }
  if (symbol != nullptr && !symbol->is_valid) return std::nullopt;
  Report(scope.diagnostics, code::kNotAssignable, assign.target.span,
         symbol != nullptr ? fmt::format("`{}` is {}, and a start sets only where the robot begins",
                                         path.front().text, WhatIs(symbol->kind))
                           : fmt::format("`{}` cannot be set", assign.target.name.text),
         {.note = "a start is made of " + ListOfStartValues()});
  return std::nullopt;
}

// The memory that is assigned to, or null after a message. A wrong declaration has had its own.
const Symbol* FindMemory(const Identifier& target, const TaskScope& scope) {
  const Symbol* symbol = FindSymbol(target, scope);
  if (symbol == nullptr) {
    if (!scope.sensors.IsRoot(target.text)) {
      ReportUnknownName(target, scope);
      return nullptr;
    }
    Report(scope.diagnostics, code::kNotAssignable, target.span,
           fmt::format("`{}` is a sensor: it can only be read", target.text));
    return nullptr;
  }
  if (!symbol->is_valid) return nullptr;
  if (symbol->kind == SymbolKind::kMemory) return symbol;
  std::string help = "declare a `memory` for what changes";
  if (symbol->kind == SymbolKind::kGoal)
    help = fmt::format("to draw it anew, write `redraw {}`", target.text);
  if (symbol->kind == SymbolKind::kPhaseTime) help = "it begins with 0 when a phase does";
  Report(scope.diagnostics, code::kNotAssignable, target.span,
         fmt::format("`{}` is {} and cannot be set by the task", target.text, WhatIs(symbol->kind)),
         {.help = std::move(help), .labels = {{symbol->span, "declared here"}}});
  return nullptr;
}

// `target op value`, with the types and units that this gives.
std::optional<CheckedExpression> Combine(const AssignStatement& assign, CheckedExpression target,
                                         CheckedExpression value, const TaskScope& scope) {
  const bool scales =
      assign.op == AssignOperator::kMultiply || assign.op == AssignOperator::kDivide;
  if (scales && !IsPlain(value.unit)) {
    Report(scope.diagnostics, code::kUnitChange, assign.value.span,
           fmt::format("this would change the unit of `{}`", assign.target.name.text),
           {.note = fmt::format("this is in {}", NameOf(value.unit)),
            .help = "multiply and divide a memory by plain numbers"});
    return std::nullopt;
  }
  const Type type = target.type;
  auto result = CheckBinaryOperator(
      OperatorOf(assign.op), Cover(assign.target.span, assign.value.span), {std::move(target)},
      {std::move(value), &assign.value}, scope.diagnostics);
  if (!result || result->type == type) return result;
  const bool is_division = assign.op == AssignOperator::kDivide;
  Report(scope.diagnostics, code::kWrongType, assign.value.span,
         fmt::format("`{}` is {}", assign.target.name.text, WithArticle(type)),
         {.note = fmt::format("the result would be {}", WithArticle(result->type)),
          .help = is_division && type.scalar == Scalar::kInt
                      ? "a division gives a `real`: declare the memory as `real`"
                      : ""});
  return std::nullopt;
}

}  // namespace

BinaryOperator OperatorOf(AssignOperator op) {
  switch (op) {
    case AssignOperator::kAdd:
      return BinaryOperator::kAdd;
    case AssignOperator::kSubtract:
      return BinaryOperator::kSubtract;
    case AssignOperator::kMultiply:
      return BinaryOperator::kMultiply;
    case AssignOperator::kDivide:
    case AssignOperator::kSet:  // has no operator; never asked for
      break;
  }
  return BinaryOperator::kDivide;
}

std::optional<CheckedAssign> CheckAssignment(const AssignStatement& assign, const Place& place,
                                             const TaskScope& scope, const CheckedTask& task) {
  if (ReportEndByFlag(assign, scope) || ReportAssignedPhase(assign, scope)) return std::nullopt;
  std::optional<Assigned> memory;
  if (place.start != nullptr) {
    memory = FindStartValue(assign, place, scope, task);
  } else if (const Symbol* symbol = FindMemory(PathOf(assign.target).front(), scope)) {
    memory = Assigned{symbol->index, symbol->type, symbol->unit};
  }
  std::optional<CheckedExpression> target;
  if (memory)
    target =
        SelectTarget({assign.target.span, memory->type, memory->unit, MemoryRead{memory->memory}},
                     assign.target, memory->length, scope);
  auto value = CheckExpression(assign.value, place, scope);
  if (!target || !value) return std::nullopt;
  const std::vector<uint32_t> elements = ElementsOf(*target);
  if (assign.op == AssignOperator::kSet) {
    auto fitting = FitTo({std::move(*value), &assign.value}, *target, assign.target, scope);
    if (!fitting) return std::nullopt;
    if (place.draws != nullptr) DrawEachElement(*fitting, target->type);
    return CheckedAssign{memory->memory, elements, assign.op, std::move(*fitting)};
  }
  const Type type = target->type;
  auto result = Combine(assign, std::move(*target), std::move(*value), scope);
  if (!result) return std::nullopt;
  if (place.draws != nullptr) DrawEachElement(*result, type);
  CheckedExpression& right = *std::get<CheckedBinary>(result->node).right;
  if (right.type == type)
    return CheckedAssign{memory->memory, elements, assign.op, std::move(right)};
  return CheckedAssign{memory->memory, elements, AssignOperator::kSet, std::move(*result)};
}

}  // namespace compiler
