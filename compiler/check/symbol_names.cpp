// What a task declares, and where it is used.
#include "compiler/check/builtins.h"
#include "compiler/check/names.h"
#include "compiler/check/phase_names.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

ReferenceKind ReferenceKindOf(SymbolKind kind) {
  switch (kind) {
    case SymbolKind::kParam:
      return ReferenceKind::kParam;
    case SymbolKind::kConst:
      return ReferenceKind::kConst;
    case SymbolKind::kSet:
      return ReferenceKind::kSet;
    case SymbolKind::kTable:
      return ReferenceKind::kTable;
    case SymbolKind::kMemory:
      return ReferenceKind::kMemory;
    case SymbolKind::kGoal:
      return ReferenceKind::kGoal;
    case SymbolKind::kPhase:
    case SymbolKind::kPhaseTime:
      return ReferenceKind::kPhase;
    case SymbolKind::kLocal:
      return ReferenceKind::kLocal;
    case SymbolKind::kLoopPart:
    case SymbolKind::kLoopNumber:
      return ReferenceKind::kLoop;
    case SymbolKind::kFunction:
      return ReferenceKind::kFunction;
    case SymbolKind::kArgument:
      return ReferenceKind::kArgument;
  }
  return ReferenceKind::kLocal;
}

void ReportTakenName(const Identifier& name, std::string_view owner, Diagnostics& diagnostics) {
  Report(diagnostics, code::kTakenName, name.span,
         fmt::format("`{}` is {} and cannot be declared", name.text, owner),
         {.help = "choose another name"});
}

}  // namespace

std::string_view WhatIs(SymbolKind kind) {
  switch (kind) {
    case SymbolKind::kParam:
      return "a param";
    case SymbolKind::kConst:
      return "a const";
    case SymbolKind::kSet:
      return "a set";
    case SymbolKind::kTable:
      return "a table";
    case SymbolKind::kMemory:
      return "a memory";
    case SymbolKind::kGoal:
      return "a goal";
    case SymbolKind::kPhase:
      return "the present phase";
    case SymbolKind::kPhaseTime:
      return "the time in the present phase";
    case SymbolKind::kLocal:
      return "the result of a `let`";
    case SymbolKind::kLoopPart:
    case SymbolKind::kLoopNumber:
      return "the variable of a loop";
    case SymbolKind::kFunction:
      return "a function";
    case SymbolKind::kArgument:
      return "a parameter of the function";
  }
  return "";
}

bool DeclareSymbol(const Identifier& name, Symbol symbol, TaskScope& scope) {
  if (IsTaken(name, scope)) {
    scope.refused.insert(name.text);
    return false;
  }
  symbol.span = name.span;
  if (scope.symbols.Declare(name.text, symbol)) {
    NoteReference(name, symbol, scope);
    return true;
  }
  const Symbol& first = *scope.symbols.Find(name.text);
  if (ComesWithPhases(first.kind)) {
    ReportNameOfPhases(name, first, scope);
    return false;
  }
  Report(scope.diagnostics, code::kRepeatedName, name.span,
         fmt::format("there is already a `{}`", name.text),
         {.labels = {{first.span, "first declared here"}}});
  return false;
}

void NoteReference(const Identifier& name, const Symbol& symbol, const TaskScope& scope) {
  // What comes with the phases has no name that could be shown or changed.
  if (scope.references == nullptr || ComesWithPhases(symbol.kind)) return;
  scope.references->Add(
      {ReferenceKindOf(symbol.kind), name.text, name.span, symbol.span, symbol.type, symbol.unit});
}

void NoteReference(const Identifier& name, ReferenceKind kind, const TaskScope& scope) {
  if (scope.references == nullptr) return;
  scope.references->AddUnique({.kind = kind, .name = name.text, .use = name.span});
}

bool IsTaken(const Identifier& name, const TaskScope& scope) {
  if (IsLanguageName(name, scope.diagnostics)) return true;
  if (!scope.sensors.IsRoot(name.text)) return false;
  ReportTakenName(name, "the name of a sensor", scope.diagnostics);
  return true;
}

bool IsLanguageName(const Identifier& name, Diagnostics& diagnostics) {
  std::string_view owner;
  if (FindBuiltin(name.text) != nullptr) {
    owner = "a function";
  } else if (FindType(name.text)) {
    owner = "a type";
  } else if (name.text == kTimeStep || name.text == kPi) {
    owner = "a built-in value";
  }
  if (owner.empty()) return false;
  ReportTakenName(name, owner, diagnostics);
  return true;
}

}  // namespace compiler
