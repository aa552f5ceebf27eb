#include "compiler/check/names.h"

#include <numbers>
#include <utility>

#include "compiler/check/builtins.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"

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

CheckedExpression ReadOf(const Symbol& symbol, Span span) {
  CheckedExpression read{span, symbol.type, symbol.unit, Constant{}};
  switch (symbol.kind) {
    case SymbolKind::kParam:
      read.node = ParamRead{symbol.index};
      break;
    case SymbolKind::kMemory:
      read.node = MemoryRead{symbol.index};
      break;
    case SymbolKind::kLocal:
      read.node = LocalRead{symbol.index};
      break;
  }
  return read;
}

std::nullopt_t NotConstant(std::string_view name, Span span, const TaskScope& scope) {
  Report(scope.diagnostics, code::kNotConstant, span,
         fmt::format("`{}` is not known before the task runs", name),
         {.help = "constants are allowed here; a memory may also start with the value of a param"});
  return std::nullopt;
}

std::optional<CheckedExpression> ResolveBuiltIn(const Identifier& name, const Place& place,
                                                const TaskScope& scope) {
  const Type real = ScalarType(Scalar::kReal);
  if (name.text == kPi) return CheckedExpression{name.span, real, {}, Constant{std::numbers::pi}};
  if (place.kind == Place::kConstant) return NotConstant(name.text, name.span, scope);
  if (name.text == kReward) {
    if (place.kind == Place::kEvent) return CheckedExpression{name.span, real, {}, RewardSoFar{}};
    Report(scope.diagnostics, code::kMisplacedReward, name.span,
           "`reward` is known only inside the block of an event",
           {.note = "it is the sum of the terms that this block has paid so far",
            .help = "add it to a `memory` there, and measure that"});
    return std::nullopt;
  }
  if (place.has_time_step()) return CheckedExpression{name.span, real, kSecond, TimeStep{}};
  Report(scope.diagnostics, code::kMisplacedTimeStep, name.span,
         "`time_step` is known only at time steps and physics steps",
         {.help = "move this to `on end_of_time_step`"});
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

void ReportUnknownSensor(const std::vector<Identifier>& path, const TaskScope& scope) {
  std::vector<std::string> siblings;
  for (std::string& name : scope.sensors.Names())
    if (name.starts_with(path[0].text + '.')) siblings.push_back(std::move(name));
  if (path.size() == 1) {
    Report(scope.diagnostics, code::kMisplacedName, path[0].span,
           fmt::format("`{}` alone is no value", path[0].text),
           {.help = fmt::format("its sensors are {}", List(siblings))});
    return;
  }
  const std::string name = Join(path, 2);
  Report(scope.diagnostics, code::kUnknownSensor, SpanOf(path, 2),
         fmt::format("there is no sensor `{}`", name),
         {.help = Suggest(name, siblings, "sensors of this kind")});
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
    Report(
        scope.diagnostics, code::kMisplacedName, name.span,
        fmt::format("`{}` stands only inside an index", name.text),
        {.help = fmt::format("write it in the brackets of an array over {}: `{}[{}]`", parts->all,
                             parts->name == "link" ? "contact" : "joint.angle", name.text)});
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
  const auto found = scope.lets.find(name.text);
  if (found == scope.lets.end()) return false;
  const bool is_later = found->second.begin > name.span.begin;
  Report(scope.diagnostics, code::kOutOfScope, name.span,
         is_later ? fmt::format("`{}` is used before its `let`", name.text)
                  : fmt::format("`{}` is known only inside the block of its `let`", name.text),
         {.help = is_later ? "move the `let` up" : "move the `let` out of the block",
          .labels = {{found->second, "defined here"}}});
  return true;
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
  if (const Symbol* symbol = scope.symbols.Find(root.text)) {
    if (!symbol->is_valid) return std::nullopt;
    if (place.kind == Place::kConstant) return NotConstant(root.text, root.span, scope);
    return ResolvedPath{ReadOf(*symbol, root.span), 1};
  }
  if (root.text == kReward || root.text == kTimeStep || root.text == kPi) {
    auto value = ResolveBuiltIn(root, place, scope);
    if (!value) return std::nullopt;
    return ResolvedPath{std::move(*value), 1};
  }
  if (const size_t length = LongestSensor(path, scope.sensors)) {
    const std::string name = Join(path, length);
    const Span span = SpanOf(path, length);
    if (scope.sensors.IsInvalid(name)) return std::nullopt;
    if (place.kind == Place::kConstant) return NotConstant(name, span, scope);
    const uint32_t index = *scope.sensors.Find(name);
    const CheckedSensor& sensor = scope.sensors.list()[index];
    return ResolvedPath{{span, sensor.type, sensor.unit, SensorRead{index}}, length};
  }
  if (ReportSensorOfRobot(path, scope)) return std::nullopt;
  if (scope.sensors.IsRoot(root.text)) {
    ReportUnknownSensor(path, scope);
  } else if (!ReportMisplacedName(root, scope)) {
    ReportUnknownName(root, scope);
  }
  return std::nullopt;
}

void DeclareSymbol(const Identifier& name, Symbol symbol, TaskScope& scope) {
  if (IsTaken(name, scope)) return;
  symbol.span = name.span;
  if (scope.symbols.Declare(name.text, symbol)) return;
  Report(scope.diagnostics, code::kRepeatedName, name.span,
         fmt::format("there is already a `{}`", name.text),
         {.labels = {{scope.symbols.Find(name.text)->span, "first declared here"}}});
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
  if (ReportInvisibleLocal(name, scope)) return;
  Report(scope.diagnostics, code::kUnknownName, name.span,
         fmt::format("there is nothing called `{}`", name.text),
         {.help = Suggest(name.text, ReadableNames(scope), "known names")});
}

}  // namespace compiler
