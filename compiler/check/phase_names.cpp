#include "compiler/check/phase_names.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "compiler/check/names.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

bool IsPresentPhase(const Expression& expression, const TaskScope& scope) {
  const auto* name = std::get_if<NameExpression>(&expression.node);
  if (name == nullptr || name->name.text != kPhase || scope.sensors.IsRoot(kPhase)) return false;
  const Symbol* symbol = scope.symbols.Find(kPhase);
  return symbol == nullptr || symbol->kind == SymbolKind::kPhase;
}

std::string ExampleIn(const TaskScope& scope) {
  return fmt::format("phase == {}", scope.phases.empty() ? "NAME" : scope.phases.back());
}

bool MayBePhaseComparison(const BinaryExpression& binary, const TaskScope& scope) {
  const bool is_equality =
      binary.op == BinaryOperator::kEqual || binary.op == BinaryOperator::kNotEqual;
  if (is_equality && binary.tolerance == nullptr) return true;
  Report(scope.diagnostics, code::kPhaseAsValue, binary.op_span,
         "a phase is another one or the same: phases have no order and no distance",
         {.help = fmt::format("ask with `==` or `!=`: `{}`", ExampleIn(scope))});
  return false;
}

CheckedExpressionPtr Number(Span span, decltype(CheckedExpression::node) node) {
  return std::make_unique<CheckedExpression>(
      CheckedExpression{span, ScalarType(Scalar::kInt), {}, std::move(node)});
}

// `phase == lift`, with the place of each part.
CheckedExpression Comparison(BinaryOperator op, Span span, Span present_span, uint32_t present,
                             Span phase_span, uint32_t phase) {
  CheckedBinary comparison{op, Number(present_span, MemoryRead{present}),
                           Number(phase_span, Constant{static_cast<double>(phase)})};
  return {span, ScalarType(Scalar::kBool), {}, std::move(comparison)};
}

void ReportNoPhases(Span span, const TaskScope& scope) {
  Report(scope.diagnostics, code::kNoPhases, span, "this task has no phases",
         {.help = "declare them: `phase NAME { ... }`; an episode begins in the first"});
}

}  // namespace

std::optional<uint32_t> FindPhase(const Identifier& name, const TaskScope& scope) {
  const auto found = std::ranges::find(scope.phases, name.text);
  if (found != scope.phases.end()) {
    NoteReference(name, ReferenceKind::kPhase, scope);
    return static_cast<uint32_t>(found - scope.phases.begin());
  }
  if (!scope.knows_names || scope.refused.contains(name.text)) return std::nullopt;
  if (scope.phases.empty()) {
    ReportNoPhases(name.span, scope);
  } else {
    Report(scope.diagnostics, code::kUnknownPhase, name.span,
           fmt::format("there is no phase `{}`", name.text),
           {.help = Suggest(name.span, name.text, scope.phases, "phases")});
  }
  return std::nullopt;
}

bool ComparesPhase(const BinaryExpression& binary, const TaskScope& scope) {
  return IsPresentPhase(*binary.left, scope) || IsPresentPhase(*binary.right, scope);
}

std::optional<CheckedExpression> CheckPhaseComparison(const BinaryExpression& binary, Span span,
                                                      const Place& place, const TaskScope& scope) {
  const bool is_left = IsPresentPhase(*binary.left, scope);
  const Expression& present = is_left ? *binary.left : *binary.right;
  const Expression& other = is_left ? *binary.right : *binary.left;
  const Symbol* symbol = scope.symbols.Find(kPhase);
  if (symbol == nullptr || place.is_constant()) {
    ResolvePath({std::get<NameExpression>(present.node).name}, place, scope);  // says why not
    return std::nullopt;
  }
  if (!MayBePhaseComparison(binary, scope)) return std::nullopt;
  const auto* name = std::get_if<NameExpression>(&other.node);
  if (name == nullptr) {
    ReportPhaseAsValue(present.span, scope);
    return std::nullopt;
  }
  const auto phase = FindPhase(name->name, scope);
  if (!phase) return std::nullopt;
  return Comparison(binary.op, span, present.span, symbol->index, other.span, *phase);
}

std::optional<CheckedExpression> PhaseFlags(const Expression& expression, const TaskScope& scope) {
  const Symbol* symbol = scope.symbols.Find(kPhase);
  if (symbol == nullptr || !IsPresentPhase(expression, scope)) return std::nullopt;
  const Span span = expression.span;
  BuiltinCall flags{Builtin::kVector, {}};
  for (uint32_t i = 0; i < scope.phases.size(); ++i)
    flags.arguments.push_back(std::make_unique<CheckedExpression>(
        Comparison(BinaryOperator::kEqual, span, span, symbol->index, span, i)));
  const auto count = static_cast<uint32_t>(scope.phases.size());
  return CheckedExpression{span, ArrayOf(ScalarType(Scalar::kBool), count), {}, std::move(flags)};
}

void ReportPhaseAsValue(Span span, const TaskScope& scope) {
  Report(scope.diagnostics, code::kPhaseAsValue, span,
         "`phase` is no value: it can only be compared with the name of a phase",
         {.help = fmt::format("write `{}`", ExampleIn(scope))});
}

void ReportNameOfPhases(const Identifier& name, const Symbol& read, const TaskScope& scope) {
  Report(scope.diagnostics, code::kRepeatedName, name.span,
         fmt::format("in a task with phases `{}` is {}", name.text, WhatIs(read.kind)),
         {.help = "choose another name", .labels = {{read.span, "the first phase"}}});
}

bool ReportMissingPhases(const Identifier& name, const TaskScope& scope) {
  const bool is_meant = name.text == kPhase || name.text == kPhaseTime;
  if (!is_meant || !scope.phases.empty() || scope.locals.contains(name.text)) return false;
  ReportNoPhases(name.span, scope);
  return true;
}

}  // namespace compiler
