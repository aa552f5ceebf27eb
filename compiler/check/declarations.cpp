#include "compiler/check/declarations.h"

#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "compiler/check/constant_value.h"
#include "compiler/check/conversion.h"
#include "compiler/check/declared_type.h"
#include "compiler/check/expressions.h"
#include "compiler/check/names.h"
#include "compiler/check/report.h"
#include "compiler/check/starts.h"
#include "compiler/check/type.h"
#include "compiler/check/worlds.h"

namespace compiler {
namespace {

constexpr Place kConstantPlace{Place::kConstant};

// Calls `check` for every declaration of one kind.
template <typename Kind, typename Check>
void ForEachDeclared(const SyntaxTree& tree, Check check) {
  for (const Declaration& declaration : tree.declarations)
    if (const auto* kind = std::get_if<Kind>(&declaration.node)) check(*kind);
}

// The value of an expression that must be a constant of this type and unit.
std::optional<double> CheckConstant(const Expression& expression, const DeclaredType& declared,
                                    const Identifier& owner, const TaskScope& scope) {
  auto value = CheckExpression(expression, kConstantPlace, scope);
  if (!value) return std::nullopt;
  const std::string place = fmt::format("`{}`", owner.text);
  value = ConvertTo({std::move(*value), &expression}, declared.type, declared.unit, place,
                    scope.diagnostics);
  if (!value) return std::nullopt;
  const double number = RealOf(*ConstantValueOf(*value, scope.constants.consts));
  if (std::isfinite(number)) return number;
  Report(scope.diagnostics, code::kNotFinite, expression.span,
         "the value of this is not a finite number");
  return std::nullopt;
}

// ---- Ranges -------------------------------------------------------------------------------------

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Range {
  double minimum = -kInfinity;
  double maximum = kInfinity;
};

bool BadRange(Span span, std::string message, const TaskScope& scope, std::string help = "") {
  Report(scope.diagnostics, code::kBadRange, span, std::move(message), {.help = std::move(help)});
  return false;
}

// `in MINIMUM .. MAXIMUM` of a param or a sensor; infinite where nothing is said. Reports mistakes
// and then returns nothing.
template <typename ParamOrSensor>
std::optional<Range> CheckRange(const ParamOrSensor& owner, const DeclaredType& declared,
                                const TaskScope& scope) {
  if (!owner.minimum || !owner.maximum) return Range{};
  const Span span = Cover(owner.minimum->span, owner.maximum->span);
  if (IsBool(declared.type)) {
    BadRange(span, "a `bool` has no range", scope);
    return std::nullopt;
  }
  const DeclaredType element{ScalarType(declared.type.scalar), declared.unit};
  const auto minimum = CheckConstant(*owner.minimum, element, owner.name, scope);
  const auto maximum = CheckConstant(*owner.maximum, element, owner.name, scope);
  if (!minimum || !maximum) return std::nullopt;
  if (*minimum <= *maximum) return Range{*minimum, *maximum};
  BadRange(span, "the range is empty", scope, "write the smaller end first");
  return std::nullopt;
}

// ---- Sensors ------------------------------------------------------------------------------------

// What a task declares beside the sensors of its robot must not be mistaken for one of them.
bool IsOfRobot(const SensorDeclaration& sensor, const Identifier& robot, TaskScope& scope) {
  const std::string known = ClashWithRobots(sensor.name.text);
  if (known.empty() && IsStartValue(sensor.name.text)) {
    Report(scope.diagnostics, code::kSensorOfRobot, sensor.name.span,
           fmt::format("`{}` is what a start sets of the robot", sensor.name.text),
           {.help = "choose another name", .labels = {{robot.span, "the robot"}}});
    return true;
  }
  if (known.empty()) return false;
  const bool is_same = known == sensor.name.text;
  Report(
      scope.diagnostics, code::kSensorOfRobot, sensor.name.span,
      is_same ? fmt::format("the robot has a sensor `{}`", known)
              : fmt::format("this could be mistaken for the robot's sensor `{}`", known),
      {.help = is_same ? "leave out the declaration, and read the robot's" : "choose another name",
       .labels = {{robot.span, "the robot"}}});
  return true;
}

// `seen`: the sensors declared before, which this one is added to.
void CheckOneSensor(const SensorDeclaration& sensor, std::map<std::string, Span>& seen,
                    TaskScope& scope) {
  const std::string& name = sensor.name.text;
  const Identifier root{name.substr(0, name.find('.')), sensor.name.span};
  if (IsLanguageName(root, scope.diagnostics)) return;
  if (const Symbol* constant = scope.symbols.Find(root.text)) {
    Report(scope.diagnostics, code::kRepeatedName, sensor.name.span,
           fmt::format("there is already a `{}`", root.text),
           {.labels = {{constant->span, "first declared here"}}});
    return scope.sensors.AddInvalid(name);
  }
  const auto [first, is_new] = seen.try_emplace(name, sensor.name.span);
  if (!is_new) {
    Report(scope.diagnostics, code::kRepeatedName, sensor.name.span,
           fmt::format("there is already a sensor `{}`", name),
           {.labels = {{first->second, "first declared here"}}});
    return;
  }
  NoteReference(sensor.name, ReferenceKind::kSensor, scope);
  const auto declared = CheckDeclaredType(sensor.type, sensor.unit, scope);
  if (!declared) {
    scope.sensors.AddInvalid(name);
    return;
  }
  const Range range = CheckRange(sensor, *declared, scope).value_or(Range{});
  const uint32_t size = declared->type.size();
  scope.sensors.Add({.name = name,
                     .doc = sensor.doc,
                     .type = declared->type,
                     .unit = declared->unit,
                     .minimum = std::vector<double>(size, range.minimum),
                     .maximum = std::vector<double>(size, range.maximum)});
}

// ---- Params -------------------------------------------------------------------------------------

class ParamCheck {
 public:
  ParamCheck(const ParamDeclaration& param, TaskScope& scope) : param_(param), scope_(scope) {}

  // All parts are looked at, so that all mistakes are reported.
  std::optional<CheckedParam> Check() {
    const auto declared = CheckDeclaredType(param_.type, param_.unit, scope_);
    if (!declared || !HasValidType(declared->type)) {
      CheckExpression(param_.initial, kConstantPlace, scope_);
      return std::nullopt;
    }
    const auto range = CheckRange(param_, *declared, scope_);
    const auto initial = CheckConstant(param_.initial, *declared, param_.name, scope_);
    if (!range || !initial) return std::nullopt;
    const bool is_bool = IsBool(declared->type);
    const CheckedParam checked{.name = param_.name.text,
                               .doc = param_.doc,
                               .type = declared->type,
                               .unit = declared->unit,
                               .initial = *initial,
                               .minimum = is_bool ? 0 : range->minimum,
                               .maximum = is_bool ? 1 : range->maximum,
                               .span = param_.name.span};
    return IsInRange(checked) ? std::optional(checked) : std::nullopt;
  }

 private:
  bool HasValidType(const Type& type) {
    if (IsScalar(type)) return true;
    Report(scope_.diagnostics, code::kBadParamType, param_.type.span,
           "a param is a single `bool`, `int` or `real`",
           {.help = "declare a param for each element"});
    return false;
  }

  bool IsInRange(const CheckedParam& checked) {
    if (checked.initial >= checked.minimum && checked.initial <= checked.maximum) return true;
    return BadRange(param_.initial.span, fmt::format("`{}` starts outside its range", checked.name),
                    scope_);
  }

  const ParamDeclaration& param_;
  TaskScope& scope_;
};

// ---- Memory -------------------------------------------------------------------------------------

// The initial value: a constant, or the value of a param. For a memory with a shape it is the value
// of each element.
std::optional<CheckedExpression> CheckInitial(const MemoryDeclaration& memory,
                                              const DeclaredType& declared,
                                              const TaskScope& scope) {
  const auto* name = std::get_if<NameExpression>(&memory.initial.node);
  const Symbol* symbol = name != nullptr ? scope.symbols.Find(name->name.text) : nullptr;
  const bool is_param = symbol != nullptr && symbol->kind == SymbolKind::kParam;
  // A param may be read here, but only as it is: so a memory never starts with what an operation on
  // a param might not give.
  const Place place = is_param ? Place{Place::kMetric} : kConstantPlace;
  auto value = CheckExpression(memory.initial, place, scope);
  if (!value) return std::nullopt;
  return ConvertTo({std::move(*value), &memory.initial}, ScalarType(declared.type.scalar),
                   declared.unit, fmt::format("`{}`", memory.name.text), scope.diagnostics);
}

void CheckOneMemory(const MemoryDeclaration& memory, TaskScope& scope, CheckedTask& task) {
  Symbol symbol{.kind = SymbolKind::kMemory, .is_valid = false};
  const auto declared = CheckDeclaredType(memory.type, memory.unit, scope);
  if (declared) {
    symbol.is_valid = true;  // what it starts with does not matter to its uses
    symbol.index = static_cast<uint32_t>(task.memory.size());
    symbol.type = declared->type;
    symbol.unit = declared->unit;
    auto initial = CheckInitial(memory, *declared, scope);
    if (!initial) initial = CheckedExpression{memory.initial.span, declared->type, {}, Constant{}};
    task.memory.push_back({memory.name.text, declared->type, declared->unit, memory.scope,
                           std::move(*initial), memory.name.span, memory.doc});
  } else {
    CheckExpression(memory.initial, kConstantPlace, scope);
  }
  DeclareSymbol(memory.name, symbol, scope);
}

}  // namespace

void CheckSensors(const SyntaxTree& tree, const world::WorldDescription* world, TaskScope& scope) {
  std::map<std::string, Span> seen;
  ForEachDeclared<SensorDeclaration>(tree, [&](const SensorDeclaration& sensor) {
    if (tree.robot && IsOfRobot(sensor, *tree.robot, scope)) return;
    if (world != nullptr && IsOfWorld(sensor, tree, *world, scope)) return;
    CheckOneSensor(sensor, seen, scope);
  });
}

void CheckParams(const SyntaxTree& tree, TaskScope& scope, CheckedTask& task) {
  ForEachDeclared<ParamDeclaration>(tree, [&](const ParamDeclaration& param) {
    Symbol symbol{.kind = SymbolKind::kParam, .is_valid = false};
    if (const auto checked = ParamCheck(param, scope).Check()) {
      symbol = {.kind = SymbolKind::kParam,
                .index = static_cast<uint32_t>(task.params.size()),
                .type = checked->type,
                .unit = checked->unit};
      task.params.push_back(*checked);
    }
    DeclareSymbol(param.name, symbol, scope);
  });
}

void CheckMemory(const SyntaxTree& tree, TaskScope& scope, CheckedTask& task) {
  ForEachDeclared<MemoryDeclaration>(
      tree, [&](const MemoryDeclaration& memory) { CheckOneMemory(memory, scope, task); });
}

void CheckMetrics(const SyntaxTree& tree, TaskScope& scope, CheckedTask& task) {
  std::map<std::string, Span> seen;
  ForEachDeclared<MetricDeclaration>(tree, [&](const MetricDeclaration& metric) {
    const auto [first, is_new] = seen.try_emplace(metric.name.text, metric.name.span);
    if (!is_new)
      Report(scope.diagnostics, code::kRepeatedName, metric.name.span,
             fmt::format("there is already a metric `{}`", metric.name.text),
             {.labels = {{first->second, "first declared here"}}});
    NoteReference(metric.name, ReferenceKind::kMetric, scope);
    auto value = CheckRealNumber(metric.value, "a metric", {Place::kMetric}, scope);
    if (!value) {
      scope.refused.insert(metric.name.text);
      return;
    }
    task.metrics.push_back(
        {metric.name.text, metric.doc, metric.reduction, std::move(*value), metric.name.span});
  });
}

}  // namespace compiler
