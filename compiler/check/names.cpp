#include "compiler/check/names.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "compiler/check/phase_names.h"
#include "compiler/check/report.h"
#include "compiler/check/starts.h"
#include "compiler/check/type.h"
#include "compiler/check/unknown_names.h"

namespace compiler {
namespace {

constexpr Unit kSecond{.second = 1};

void ReportSetAsValue(const Identifier& name, const Symbol& symbol, const TaskScope& scope) {
  const std::string& parts = scope.constants.sets[symbol.index].parts;
  const std::string_view array = parts.empty() ? "x" : SensorOver(parts);
  Report(scope.diagnostics, code::kMisplacedName, name.span,
         fmt::format("`{}` is a set: it is allowed only inside an index, and in a loop", name.text),
         {.help = fmt::format("pick elements with it: `{}[{}]`", array, name.text),
          .labels = {{symbol.span, "declared here"}}});
}

// Nothing, after a message, where a symbol is no value.
std::optional<CheckedExpression> ReadOf(const Symbol& symbol, const Identifier& name,
                                        const TaskScope& scope) {
  CheckedExpression read{name.span, symbol.type, symbol.unit, Constant{}};
  switch (symbol.kind) {
    case SymbolKind::kParam:
      read.node = ParamRead{symbol.index};
      break;
    case SymbolKind::kConst: {
      const CheckedConst& constant = scope.constants.consts[symbol.index];
      if (IsScalar(constant.type)) {
        read.node = Constant{constant.elements.front()};
      } else {
        read.node = ConstRead{symbol.index};
      }
      break;
    }
    case SymbolKind::kSet:
      ReportSetAsValue(name, symbol, scope);
      return std::nullopt;
    case SymbolKind::kTable:
      Report(scope.diagnostics, code::kMisplacedName, name.span,
             fmt::format("`{}` is a table", name.text),
             {.help = fmt::format("read it with an argument: `{}(x)`", name.text),
              .labels = {{symbol.span, "declared here"}}});
      return std::nullopt;
    case SymbolKind::kMemory:
    case SymbolKind::kGoal:
    case SymbolKind::kPhaseTime:
      read.node = MemoryRead{symbol.index};
      break;
    case SymbolKind::kPhase:
      ReportPhaseAsValue(name.span, scope);
      return std::nullopt;
    case SymbolKind::kLocal:
      read.node = LocalRead{symbol.index};
      break;
    case SymbolKind::kLoopNumber:
      read.node = Constant{static_cast<double>(symbol.index)};
      break;
    case SymbolKind::kArgument:
      read.node = ArgumentRead{symbol.index};
      break;
    case SymbolKind::kLoopPart:
      ReportPartAsValue(name, symbol.type.index, scope);
      return std::nullopt;
    case SymbolKind::kFunction:
      Report(scope.diagnostics, code::kMisplacedName, name.span,
             fmt::format("`{}` is a function", name.text),
             {.help = fmt::format("write `{}`", UsageOf(scope.functions[symbol.index])),
              .labels = {{symbol.span, "declared here"}}});
      return std::nullopt;
  }
  return read;
}

// What a function of the past needs is computed before the block, and in each time step.
std::nullopt_t LocalInPast(const Identifier& name, const Symbol& symbol, const TaskScope& scope) {
  Report(scope.diagnostics, code::kLocalInPast, name.span,
         fmt::format("`{}` is known only from here on, and only in this block", name.text),
         {.note = "functions that look back in time are computed in each step, before the blocks",
          .help = fmt::format("write what `{}` is computed from in its place, or a `fn` of it",
                              name.text),
          .labels = {{symbol.span, "declared here"}}});
  return std::nullopt;
}

std::nullopt_t NotInGoal(std::string_view sensor, Span span, const TaskScope& scope) {
  Report(scope.diagnostics, code::kSensorInGoal, span,
         fmt::format("`{}` is a sensor, and a goal is drawn from params and memory", sensor),
         {.help = "keep what the goal needs in a `memory`, and `redraw` it where that is set"});
  return std::nullopt;
}

std::nullopt_t NotInStart(std::string_view sensor, Span span, const TaskScope& scope) {
  Report(scope.diagnostics, code::kSensorInStart, span,
         fmt::format("`{}` has no value before the episode begins", sensor),
         {.note = "a start is made of " + ListOfStartValues()});
  return std::nullopt;
}

// The number of names of the longest sensor name that `path` begins with; 0 if there is none.
size_t LongestSensor(const std::vector<Identifier>& path, const SensorCatalog& sensors) {
  for (size_t length = path.size(); length > 0; --length) {
    const std::string name = PathText(path, length);
    if (sensors.Find(name) || sensors.IsInvalid(name)) return length;
  }
  return 0;
}

// A name that is known around a function, which cannot read it. False: it is not known there.
bool ReportOutsideOfFunction(const std::vector<Identifier>& path, const TaskScope& around) {
  const std::string& root = path[0].text;
  std::string_view what;
  size_t length = 1;
  if (const Symbol* symbol = around.symbols.Find(root)) {
    if (IsNamedConstant(*symbol)) return false;  // hidden by what the function declares itself
    what = WhatIs(symbol->kind);
  } else if (root == kReward || root == kTimeStep) {
    what = "a value of the event";
  } else if (around.sensors.IsRoot(root) || IsSensorOfRobots(root)) {
    what = "a sensor";
    length = std::max<size_t>(LongestSensor(path, around.sensors), 1);
  } else {
    return false;
  }
  Report(around.diagnostics, code::kImpureFunction, SpanOfPath(path, length),
         fmt::format("`{}` is {}, and a function computes from its parameters alone",
                     PathText(path, length), what),
         {.help = "give the function a parameter for it"});
  return true;
}

std::optional<CheckedExpression> ResolveBuiltIn(const Identifier& name, const Place& place,
                                                const TaskScope& scope) {
  if (name.text == kPi)
    return CheckedExpression{name.span, kRealType, {}, Constant{std::numbers::pi}};
  if (place.is_constant()) return NotConstant(name.text, name.span, place, scope);
  if (name.text == kReward) {
    if (place.kind == Place::kEvent)
      return CheckedExpression{name.span, kRealType, {}, RewardSoFar{}};
    if (place.kind == Place::kExpect)
      return CheckedExpression{name.span, kRealType, {}, TestRead{TestRead::kReward}};
    Report(scope.diagnostics, code::kMisplacedReward, name.span,
           "`reward` is known only inside the block of an event",
           {.note = "it is the sum of the terms that this block has paid so far",
            .help = place.kind == Place::kPotential
                        ? "a potential says how good it is to be somewhere: let it read sensors"
                        : fmt::format("add it to a `memory` there, and {} that",
                                      place.kind == Place::kObservation ? "observe" : "measure")});
    return std::nullopt;
  }
  if (place.has_time_step()) return CheckedExpression{name.span, kRealType, kSecond, TimeStep{}};
  const bool is_between_events = place.kind == Place::kExpect || place.kind == Place::kPotential ||
                                 place.kind == Place::kStart;
  if (is_between_events) {
    Report(scope.diagnostics, code::kMisplacedTimeStep, name.span,
           "`time_step` has no value between events",
           {.help = "write the length itself, such as `5 ms`"});
    return std::nullopt;
  }
  Report(scope.diagnostics, code::kMisplacedTimeStep, name.span,
         "`time_step` is known only at time steps and physics steps",
         {.help = place.kind == Place::kObservation
                      ? "keep what you need of it in a `memory`, and observe that"
                      : "move this to `on end_of_time_step`"});
  return std::nullopt;
}

// A sensor of the robot has no definition in the task.
void NoteSensor(const std::string& name, Span use, const CheckedSensor& sensor,
                const TaskScope& scope) {
  if (scope.references == nullptr) return;
  Reference reference{ReferenceKind::kSensor, name, use, {}, sensor.type, sensor.unit};
  if (scope.has_robot) {
    scope.references->Add(reference);
  } else {
    scope.references->AddUnique(std::move(reference));
  }
}

// Its elements, listed.
CheckedExpression ConstantOf(const CheckedSensor& sensor, Span span) {
  BuiltinCall list{Builtin::kVector, {}};
  for (const double value : sensor.constant)
    list.arguments.push_back(std::make_unique<CheckedExpression>(
        CheckedExpression{span, kRealType, sensor.unit, Constant{value}}));
  return {span, sensor.type, sensor.unit, std::move(list)};
}

}  // namespace

std::optional<ResolvedPath> ResolvePath(const std::vector<Identifier>& path, const Place& place,
                                        const TaskScope& scope) {
  const Identifier& root = path[0];
  if (const Symbol* symbol = FindSymbol(root, scope)) {
    if (!symbol->is_valid) return std::nullopt;
    if (place.kind == Place::kTimed && symbol->kind == SymbolKind::kLocal)
      return LocalInPast(root, *symbol, scope);
    if (place.is_constant() && !IsNamedConstant(*symbol))
      return NotConstant(root.text, root.span, place, scope);
    auto value = ReadOf(*symbol, root, scope);
    if (!value) return std::nullopt;
    return ResolvedPath{std::move(*value), 1};
  }
  if (scope.refused.contains(root.text)) return std::nullopt;
  const bool is_around = scope.around != nullptr && root.text != kPi;
  if (is_around && ReportOutsideOfFunction(path, *scope.around)) return std::nullopt;
  if (root.text == kEnded && place.kind == Place::kExpect)
    return ResolvedPath{{root.span, ScalarType(Scalar::kBool), {}, TestRead{TestRead::kEnded}}, 1};
  if (root.text == kReward || root.text == kTimeStep || root.text == kPi) {
    auto value = ResolveBuiltIn(root, place, scope);
    if (!value) return std::nullopt;
    return ResolvedPath{std::move(*value), 1};
  }
  if (place.start != nullptr)
    if (const auto found = place.start->Find(path))
      return ResolvedPath{place.start->Read(*found, SpanOfPath(path, found->length)),
                          found->length};
  if (const size_t length = LongestSensor(path, scope.sensors)) {
    const std::string name = PathText(path, length);
    const Span span = SpanOfPath(path, length);
    if (scope.sensors.IsInvalid(name)) return std::nullopt;
    const uint32_t index = *scope.sensors.Find(name);
    const CheckedSensor& sensor = scope.sensors.list()[index];
    if (!sensor.constant.empty()) {
      NoteSensor(name, span, sensor, scope);
      return ResolvedPath{ConstantOf(sensor, span), length};
    }
    if (place.is_constant()) return NotConstant(name, span, place, scope);
    if (place.kind == Place::kGoal) return NotInGoal(name, span, scope);
    if (place.kind == Place::kStart) return NotInStart(name, span, scope);
    NoteSensor(name, span, sensor, scope);
    return ResolvedPath{{span, sensor.type, sensor.unit, SensorRead{index}}, length};
  }
  ReportUnknownPath(path, scope);
  return std::nullopt;
}

const Symbol* FindSymbol(const Identifier& name, const TaskScope& scope) {
  const Symbol* symbol = scope.symbols.Find(name.text);
  if (symbol != nullptr && IsLoopVariable(*symbol)) scope.loop_reads->push_back(name);
  if (symbol != nullptr && IsNamedConstant(*symbol)) scope.constants.used.insert(name.text);
  if (symbol != nullptr) NoteReference(name, *symbol, scope);
  return symbol;
}

}  // namespace compiler
