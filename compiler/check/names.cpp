#include "compiler/check/names.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "compiler/check/builtins.h"
#include "compiler/check/draws.h"
#include "compiler/check/phase_names.h"
#include "compiler/check/report.h"
#include "compiler/check/starts.h"
#include "compiler/check/time_functions.h"
#include "compiler/check/type.h"
#include "compiler/syntax/foreign_words.h"
#include "compiler/syntax/power_help.h"

namespace compiler {
namespace {

constexpr Unit kSecond{.second = 1};

// The first `length` names of a path, with dots.
std::string Join(const std::vector<Identifier>& path, size_t length) {
  std::string text = path[0].text;
  for (size_t i = 1; i < length; ++i) text += '.' + path[i].text;
  return text;
}

Span SpanOf(const std::vector<Identifier>& path, size_t length) {
  return Cover(path[0].span, path[length - 1].span);
}

std::vector<std::string> ReadableNames(const TaskScope& scope) {
  std::vector<std::string> names = scope.symbols.Names();
  for (std::string& sensor : scope.sensors.Names()) names.push_back(std::move(sensor));
  for (const std::string_view built_in : {kReward, kTimeStep, kPi}) names.emplace_back(built_in);
  return names;
}

// `enumeration`: "link" or "joint".
void ReportPartAsValue(const Identifier& name, std::string_view enumeration,
                       const TaskScope& scope) {
  const std::string element =
      fmt::format("{}[{}]", enumeration == "link" ? "contact" : "joint.angle", name.text);
  Report(scope.diagnostics, code::kMisplacedName, name.span,
         fmt::format("`{}` is allowed only inside an index", name.text),
         {.help = {fmt::format("write it in the brackets of an array over {}s: `{}`", enumeration,
                               element),
                   {{name.span, element}}}});
}

void ReportSetAsValue(const Identifier& name, const Symbol& symbol, const TaskScope& scope) {
  const std::string& parts = scope.constants.sets[symbol.index].parts;
  const std::string_view array = parts == "link"    ? "contact"
                                 : parts == "joint" ? "joint.angle"
                                                    : "x";
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

std::nullopt_t NotConstant(std::string_view name, Span span, const Place& place,
                           const TaskScope& scope) {
  Report(scope.diagnostics, code::kNotConstant, span,
         fmt::format("`{}` is not known before the task runs", name),
         {.help = place.kind == Place::kGiven
                      ? "a test gives constants"
                      : "constants are allowed here; a memory may also start with the value of a "
                        "param"});
  return std::nullopt;
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
    const std::string name = Join(path, length);
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
  Report(around.diagnostics, code::kImpureFunction, SpanOf(path, length),
         fmt::format("`{}` is {}, and a function computes from its parameters alone",
                     Join(path, length), what),
         {.help = "give the function a parameter for it"});
  return true;
}

std::optional<CheckedExpression> ResolveBuiltIn(const Identifier& name, const Place& place,
                                                const TaskScope& scope) {
  const Type real = ScalarType(Scalar::kReal);
  if (name.text == kPi) return CheckedExpression{name.span, real, {}, Constant{std::numbers::pi}};
  if (place.is_constant()) return NotConstant(name.text, name.span, place, scope);
  if (name.text == kReward) {
    if (place.kind == Place::kEvent) return CheckedExpression{name.span, real, {}, RewardSoFar{}};
    if (place.kind == Place::kExpect)
      return CheckedExpression{name.span, real, {}, TestRead{TestRead::kReward}};
    Report(scope.diagnostics, code::kMisplacedReward, name.span,
           "`reward` is known only inside the block of an event",
           {.note = "it is the sum of the terms that this block has paid so far",
            .help = place.kind == Place::kPotential
                        ? "a potential says how good it is to be somewhere: let it read sensors"
                        : fmt::format("add it to a `memory` there, and {} that",
                                      place.kind == Place::kObservation ? "observe" : "measure")});
    return std::nullopt;
  }
  if (place.has_time_step()) return CheckedExpression{name.span, real, kSecond, TimeStep{}};
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

// A sensor of several names that `path` begins with, were it not for a few wrong letters. False:
// there is none.
bool ReportMisspelledSensor(const std::vector<Identifier>& path, const TaskScope& scope) {
  std::string nearest;
  size_t length = 0;
  size_t smallest = std::string::npos;
  for (const std::string& name : scope.sensors.Names()) {
    const auto parts = static_cast<size_t>(1 + std::ranges::count(name, '.'));
    if (parts < 2 || parts > path.size()) continue;
    const auto distance = text::DottedDistance(Join(path, parts), name);
    if (!distance || *distance >= smallest) continue;
    nearest = name;
    length = parts;
    smallest = *distance;
  }
  if (nearest.empty()) return false;
  const Span span = SpanOf(path, length);
  Report(scope.diagnostics, code::kUnknownSensor, span,
         fmt::format("there is no sensor `{}`", Join(path, length)),
         {.help = DidYouMean(span, nearest)});
  return true;
}

// `path` begins as sensors do.
void ReportUnknownSensor(const std::vector<Identifier>& path, const TaskScope& scope) {
  std::vector<std::string> siblings;
  for (std::string& name : scope.sensors.Names())
    if (name.starts_with(path[0].text + '.')) siblings.push_back(std::move(name));
  if (path.size() == 1) {
    Report(scope.diagnostics, code::kMisplacedName, path[0].span,
           fmt::format("`{}` alone is not a value", path[0].text),
           {.help = fmt::format("its sensors are {}", List(siblings))});
    return;
  }
  Report(scope.diagnostics, code::kUnknownSensor, SpanOf(path, 2),
         fmt::format("there is no sensor `{}`", Join(path, 2)),
         {.help = fmt::format("the sensors of this kind are {}", List(siblings))});
}

// A sensor that robots have, in a task without a robot. False: it is no such sensor.
bool ReportSensorOfRobot(const std::vector<Identifier>& path, const TaskScope& scope) {
  for (size_t length = path.size(); length > 0 && !scope.has_robot; --length) {
    const std::string name = Join(path, length);
    if (!IsSensorOfRobots(name)) continue;
    const std::string declaration = DeclarationOf(name);
    Report(scope.diagnostics, code::kUnknownSensor, SpanOf(path, length),
           fmt::format("`{}` is a sensor of robots, and this task names no robot", name),
           {.help = declaration.empty()
                        ? "write `for ROBOT` after the task's name"
                        : fmt::format("write `for ROBOT` after the task's name, or declare `{}`",
                                      declaration)});
    return true;
  }
  return false;
}

// A name that means something, but not as a value. False: it means nothing at all.
bool ReportMisplacedName(const Identifier& name, const TaskScope& scope) {
  if (const Enumeration* parts = FindEnumerationOf(scope.enumerations, name.text)) {
    ReportPartAsValue(name, parts->name, scope);
    return true;
  }
  if (const BuiltinDescription* builtin = FindBuiltin(name.text)) {
    Report(scope.diagnostics, code::kMisplacedName, name.span,
           fmt::format("`{}` is a function", name.text),
           {.help = fmt::format("write `{}`", builtin->usage)});
    return true;
  }
  return false;
}

// A local value of the event that is not visible here. False: there is none of this name.
bool ReportInvisibleLocal(const Identifier& name, const TaskScope& scope) {
  const auto found = scope.locals.find(name.text);
  if (found == scope.locals.end()) return false;
  const Span defined = found->second.span;
  if (found->second.is_loop) {
    Report(scope.diagnostics, code::kOutOfScope, name.span,
           fmt::format("`{}` is known only inside its loop", name.text),
           {.labels = {{defined, "defined here"}}});
    return true;
  }
  const bool is_later = defined.begin > name.span.begin;
  Report(scope.diagnostics, code::kOutOfScope, name.span,
         is_later ? fmt::format("`{}` is used before its `let`", name.text)
                  : fmt::format("`{}` is known only inside the block of its `let`", name.text),
         {.help = is_later ? "move the `let` up" : "move the `let` out of the block",
          .labels = {{defined, "defined here"}}});
  return true;
}

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

// `True`, `dt`; `sec` and `s2` behind a unit and `/`.
Help HelpForForeignName(const Identifier& name) {
  Help help = HelpForForeign(ForeignPlace::kOperand, name.text, name.span);
  if (help.empty()) help = HelpForPowerInName(name.text, name.span);
  if (help.empty()) help = HelpForForeign(ForeignPlace::kUnit, name.text, name.span);
  return help;
}

// `math.pi`, `self.speed`: a path that begins with a word of other languages. False: it does not.
bool ReportForeignPath(const std::vector<Identifier>& path, const TaskScope& scope) {
  if (path.size() < 2) return false;
  const Identifier& root = path.front();
  const Span prefix{root.span.begin, path[1].span.begin};
  const bool is_module = FindForeign(ForeignPlace::kModule, root.text) != nullptr;
  const bool is_owner = root.text == "self" || root.text == "this";
  if (!is_module && !is_owner) return false;
  Help help = fmt::format("leave out `{}.`: a task has one namespace", root.text);
  help.fixes = {{prefix, ""}};
  Report(scope.diagnostics, code::kUnknownName, root.span,
         fmt::format("there is nothing called `{}`", root.text), {.help = std::move(help)});
  return true;
}

// Its elements, listed.
CheckedExpression ConstantOf(const CheckedSensor& sensor, Span span) {
  BuiltinCall list{Builtin::kVector, {}};
  for (const double value : sensor.constant)
    list.arguments.push_back(std::make_unique<CheckedExpression>(
        CheckedExpression{span, ScalarType(Scalar::kReal), sensor.unit, Constant{value}}));
  return {span, sensor.type, sensor.unit, std::move(list)};
}

void ReportTakenName(const Identifier& name, std::string_view owner, Diagnostics& diagnostics) {
  Report(diagnostics, code::kTakenName, name.span,
         fmt::format("`{}` is {} and cannot be declared", name.text, owner),
         {.help = "choose another name"});
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
      return ResolvedPath{place.start->Read(*found, SpanOf(path, found->length)), found->length};
  if (const size_t length = LongestSensor(path, scope.sensors)) {
    const std::string name = Join(path, length);
    const Span span = SpanOf(path, length);
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
  if (!scope.knows_names || scope.sensors.IsInvalidRoot(root.text)) return std::nullopt;
  if (ReportMissingPhases(root, scope) || ReportForeignPath(path, scope)) return std::nullopt;
  if (ReportSensorOfRobot(path, scope) || ReportMisspelledSensor(path, scope)) return std::nullopt;
  if (scope.sensors.IsRoot(root.text)) {
    ReportUnknownSensor(path, scope);
  } else if (!ReportMisplacedName(root, scope)) {
    ReportUnknownName(root, scope);
  }
  return std::nullopt;
}

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

const FunctionSignature* ResolveFunction(const Identifier& name, const Place& place,
                                         const TaskScope& scope) {
  const Symbol* symbol = scope.symbols.Find(name.text);
  if (symbol != nullptr && symbol->kind == SymbolKind::kFunction) {
    NoteReference(name, *symbol, scope);
    if (!place.is_constant()) return &scope.functions[symbol->index];
    NotConstant(name.text, name.span, place, scope);
    return nullptr;
  }
  if (symbol != nullptr) {
    Report(scope.diagnostics, code::kUnknownFunction, name.span,
           fmt::format("`{}` is {}, not a function", name.text, WhatIs(symbol->kind)),
           {.labels = {{symbol->span, "declared here"}}});
    return nullptr;
  }
  if (!scope.knows_functions || scope.refused.contains(name.text)) return nullptr;
  std::vector<std::string> functions = BuiltinNames();
  for (const FunctionSignature& function : scope.functions) functions.push_back(function.name.text);
  for (const TimeFunctionDescription& each : kTimeFunctions) functions.emplace_back(each.name);
  for (const CheckedTable& table : scope.constants.tables) functions.push_back(table.name);
  if (place.kind == Place::kExpect)
    for (const std::string_view of_test : kTestFunctions) functions.emplace_back(of_test);
  if (IsDrawFunction(name.text)) {
    Report(scope.diagnostics, code::kMisplacedDraw, name.span,
           fmt::format("`{}` draws a random number, which only goals and starts do", name.text),
           {.help = "declare a goal and read it here: `goal NAME: TYPE = ...`"});
    return nullptr;
  }
  Help help = HelpForForeign(ForeignPlace::kFunction, name.text, name.span);
  if (help.empty()) help = Suggest(name.span, name.text, functions, "functions");
  if (help.empty()) help = fmt::format("the functions are {}", List(functions));
  if (IsTestFunction(name.text)) help = "it is known only after the `expect` of a test";
  if (help.fixes.empty() && !scope.reported.insert(name.text).second) return nullptr;
  Report(scope.diagnostics, code::kUnknownFunction, name.span,
         fmt::format("there is no function `{}`{}", name.text,
                     IsTestFunction(name.text) ? " here" : ""),
         {.help = std::move(help)});
  return nullptr;
}

std::string UsageOf(const FunctionSignature& function) {
  std::string parameters;
  for (const Local& parameter : function.parameters)
    parameters += (parameters.empty() ? "" : ", ") + parameter.name;
  return fmt::format("{}({})", function.name.text, parameters);
}

const Symbol* FindSymbol(const Identifier& name, const TaskScope& scope) {
  const Symbol* symbol = scope.symbols.Find(name.text);
  if (symbol != nullptr && IsLoopVariable(*symbol)) scope.loop_reads->push_back(name);
  if (symbol != nullptr && IsNamedConstant(*symbol)) scope.constants.used.insert(name.text);
  if (symbol != nullptr) NoteReference(name, *symbol, scope);
  return symbol;
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

void ReportUnknownName(const Identifier& name, const TaskScope& scope) {
  if (!scope.knows_names || scope.refused.contains(name.text)) return;
  if (ReportInvisibleLocal(name, scope)) return;
  Help help = HelpForForeignName(name);
  if (help.empty()) help = Suggest(name.span, name.text, ReadableNames(scope), "known names");
  if (help.fixes.empty() && !scope.reported.insert(name.text).second) return;
  Report(scope.diagnostics, code::kUnknownName, name.span,
         fmt::format("there is nothing called `{}`", name.text), {.help = std::move(help)});
}

}  // namespace compiler
